// Second stage of a step: what coincides, and what the rays are inside of before and after it.

#if defined(MENISCUS_LANES_LISTS) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_LISTS
#undef MENISCUS_LANES_LISTS
#else
#define MENISCUS_LANES_LISTS
#endif

#include "lanes/kernel-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

/// The face number of a contact, in its place in the word of all contacts; 15: some face beyond the
/// numbers that fit.
HWY_INLINE U contact_word(F face, int index) {
    const F with_exponent = min(face + F(1.0), F(15.0)) + F(0x1p52);
    return shift_left(
        U(hn::BitCast(integers, with_exponent.a), hn::BitCast(integers, with_exponent.b)) & U(15),
        4 * index);
}

/// What coincides with the nearest true crossing, and the lists just before and just after.
HWY_INLINE void Kernel::make_lists(Batch& batch, Top& before, Top& after) {
    const Rays& rays = batch.rays;
    batch.met = rays.active & (batch.nearest < F(infinity)) & (batch.nearest <= rays.t_max);
    const F t = select(batch.met, batch.nearest, min(rays.t_max, F(1e300)));
    batch.t = t;
    batch.before = batch.after = {U(0), U(0)};
    batch.contacts = U(0);
    batch.surface = F(double(no_rank));
    batch.surface_face = F(0.0);
    batch.false_crossings = F(0.0);
    const F units(program_.tolerance_units * unit_roundoff), least(program_.contact_tolerance);
    const F pivot = program_.one_tolerance ? F(program_.largest_magnitude) : batch.pivot_magnitude;
    const F far = rays.largest + t;
    const F reach = max(F(1e-7) * (far + pivot), F(100.0) * least);
    const F common = max(units * (far + pivot), least);
    M torn = no_lanes();
    for (std::size_t i = 0; i < program_.solids.size(); ++i) {
        const Solid& solid = program_.solids[i];
        if (!batch.is_near[i] && !solid.inverse) continue;  // nowhere before, nowhere after
        const F tolerance = program_.one_tolerance
                                ? common
                                : max(units * (far + max(pivot, F(solid.magnitude))), least);
        const F low = t - tolerance, high = t + tolerance;
        M is_before = no_lanes(), is_after = is_before, once = is_before;
        F face(0.0);
        for (std::size_t part = 0; part < (has_two_stretches(solid.kind) ? 2 : 1); ++part) {
            const Stretch& stretch = batch.stretches[2 * i + part];
            const M entered = stretch.in < low, entered_after = stretch.in <= high;
            const M left = stretch.out < low, left_after = stretch.out <= high;
            const M enters = entered ^ entered_after, leaves = left ^ left_after;
            torn = torn | (enters ^ (abs(stretch.in - t) <= reach)) |
                   (leaves ^ (abs(stretch.out - t) <= reach));
            is_before = is_before | but_not(entered, left);
            is_after = is_after | but_not(entered_after, left_after);
            once = once ^ enters ^ leaves;
            const M fresh = but_not(entered, stretch.in == F(-infinity));
            if (any(fresh | left))
                batch.false_crossings =
                    batch.false_crossings + only(fresh, F(1.0)) + only(left, F(1.0));
            if (solid.kind != Kind::sphere && solid.kind != Kind::half_space)
                face = select(enters, stretch.face_in, select(leaves, stretch.face_out, face));
        }
        batch.contacts = batch.contacts | only(once, contact_word(face, int(i)));
        if (solid.inverse) {
            is_before = !is_before;
            is_after = !is_after;
        }
        const U bit(1ull << (solid.place % 64));
        if (solid.place < 64) {
            batch.before.low = batch.before.low | only(is_before, bit);
            batch.after.low = batch.after.low | only(is_after, bit);
        } else {
            batch.before.high = batch.before.high | only(is_before, bit);
            batch.after.high = batch.after.high | only(is_after, bit);
        }
        if (solid.rank < 0) {
            batch.surface = select(once, F(double(i)), batch.surface);
            batch.surface_face = select(once, face, batch.surface_face);
            continue;
        }
        // Solids stand in the order of their ranks.
        const Member& member = program_.members[std::size_t(solid.rank)];
        before.cover(is_before, solid.rank, member);
        after.cover(is_after, solid.rank, member);
        before.face = select(is_before, face, before.face);
        after.face = select(is_after, face, after.face);
    }
    if (!program_.groups.empty()) list_small_spheres(batch, pivot, reach, torn, before, after);
    batch.unsure = rays.active & (batch.unsure | (batch.met & torn));
}

/// The same for small spheres, lane by lane.
HWY_INLINE void Kernel::list_small_spheres(Batch& batch, F pivot, F reach, M& torn, Top& before,
                                           Top& after) {
    const Doubles at(batch.t), margin(reach), largest(batch.rays.largest), pivots(pivot);
    std::uint32_t doubtful = 0, covered_before = 0, covered_after = 0;
    Doubles rank_before(before.rank), rank_after(after.rank), skipped(batch.false_crossings);
    Words low_before(batch.before.low), high_before(batch.before.high), low_after(batch.after.low),
        high_after(batch.after.high);
    batch.sphere_contacts_after = Words(U(0));
    for_each(batch.rays.active, [&](std::size_t lane) {
        const SphereStretches& list = batch.spheres[lane];
        int contacts = 0;
        for (int k = 0; k < list.size; ++k) {
            const SphereStretch& stretch = list.at[k];
            const double tolerance =
                std::max(program_.tolerance_units * unit_roundoff *
                             (largest[lane] + at[lane] +
                              std::max(pivots[lane], magnitudes_[std::size_t(stretch.rank)])),
                         program_.contact_tolerance);
            const double low = at[lane] - tolerance, high = at[lane] + tolerance;
            const bool entered = stretch.in < low, entered_after = stretch.in <= high;
            const bool left = stretch.out < low, left_after = stretch.out <= high;
            const bool enters = entered != entered_after, leaves = left != left_after;
            if (enters != (std::abs(stretch.in - at[lane]) <= margin[lane]) ||
                leaves != (std::abs(stretch.out - at[lane]) <= margin[lane]))
                doubtful |= 1u << lane;
            const std::uint64_t bit = 1ull << (stretch.rank % 64);
            if (entered && !left) {
                (stretch.rank < 64 ? low_before : high_before)[lane] |= bit;
                if (rank_before[lane] < stretch.rank) {
                    rank_before[lane] = stretch.rank;
                    covered_before |= 1u << lane;
                }
            }
            if (entered_after && !left_after) {
                (stretch.rank < 64 ? low_after : high_after)[lane] |= bit;
                if (rank_after[lane] < stretch.rank) {
                    rank_after[lane] = stretch.rank;
                    covered_after |= 1u << lane;
                }
            }
            if (enters != leaves) {
                if (contacts == 2) {
                    doubtful |= 1u << lane;
                } else {
                    batch.sphere_contacts_after[lane] |= std::uint64_t(stretch.rank + 1)
                                                         << (32 * contacts++);
                }
            }
            skipped[lane] += (entered && stretch.in > -infinity) + left;
        }
    });
    torn = torn | mask_of(doubtful);
    batch.false_crossings = load(skipped.at);
    batch.before = {load(low_before.at), load(high_before.at)};
    batch.after = {load(low_after.at), load(high_after.at)};
    const auto cover = [&](std::uint32_t which, const Doubles& ranks, Top& top) {
        if (which == 0) return;
        Doubles iors(top.ior), media(top.medium);
        std::uint32_t dressed = bits(top.dressed), attenuates = bits(top.attenuates);
        for (std::uint32_t left = which; left; left &= left - 1) {
            const std::size_t lane = std::size_t(__builtin_ctz(left));
            const Member& member = program_.members[std::size_t(ranks[lane])];
            iors[lane] = member.ior;
            media[lane] = double(member.medium);
            const std::uint32_t bit = 1u << lane;
            dressed = member.clear ? dressed & ~bit : dressed | bit;
            attenuates = member.attenuates ? attenuates | bit : attenuates & ~bit;
        }
        top.rank = load(ranks.at);
        top.ior = load(iors.at);
        top.medium = load(media.at);
        top.dressed = mask_of(dressed);
        top.attenuates = mask_of(attenuates);
    };
    cover(covered_before, rank_before, before);
    cover(covered_after, rank_after, after);
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
