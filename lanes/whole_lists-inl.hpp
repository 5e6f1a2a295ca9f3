// Events and lists from the whole stretches of all solids.

#if defined(MENISCUS_LANES_WHOLE_LISTS) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_WHOLE_LISTS
#undef MENISCUS_LANES_WHOLE_LISTS
#else
#define MENISCUS_LANES_WHOLE_LISTS
#endif

#include "lanes/lists-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

/// The event: the nearest true crossing, what coincides with it, and the lists just before and
/// just after, from all stretches.
inline void Kernel::find_event(Batch& batch, const Findings& found) {
    const Rays& rays = batch.rays;
    const F nearest = found.nearest.t;
    batch.met = rays.active & (nearest < F(infinity));
    F farthest(1e300);
    if (batch.is_shadow) {
        batch.met = batch.met & (nearest <= rays.t_max);
        farthest = min(rays.t_max, farthest);
    }
    batch.t = select(batch.met, nearest, farthest);
    make_lists(batch, found.nearest.index);
}

/// The lists anew, from all stretches: what lies within the tolerance of the event counts together.
void Kernel::make_lists(Batch& batch, U nearest) {
    batch.has_passed = true;
    Top before(program_.outside), after(program_.outside);
    const Rays& rays = batch.rays;
    const F t = batch.t;
    for (int w = 0; w < program_.words; ++w) batch.before.word[w] = batch.after.word[w] = U(0);
    batch.contacts = U(0);
    Owner surface;
    batch.false_crossings = F(0.0);
    const F units(program_.tolerance_units * unit_roundoff), least(program_.contact_tolerance);
    F pivot;
    const F reach = bounds_of_event(batch, nearest, pivot);
    const F far = rays.largest + t;
    const F common = max(units * (far + pivot), least);
    F low = t - common, high = t + common;
    M torn = no_lanes();
    for (std::size_t i = 0; i < program_.solids.size(); ++i) {
        const Solid& solid = program_.solids[i];
        if (!batch.is_near[i] && !solid.inverse) continue;  // nowhere before, nowhere after
        if (!program_.one_tolerance) {
            const F tolerance = max(units * (far + max(pivot, F(solid.magnitude))), least);
            low = t - tolerance;
            high = t + tolerance;
        }
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
            const M fresh = entered & (F(0.0) <= stretch.in);
            if (any(fresh | left))
                batch.false_crossings =
                    batch.false_crossings + only(fresh, F(1.0)) + only(left, F(1.0));
            if (has_faces(solid.kind))
                face = select(enters, stretch.face_in, select(leaves, stretch.face_out, face));
        }
        batch.contacts =
            batch.contacts |
            only(once, has_faces(solid.kind) ? contact_word(face, int(i)) : U(1ull << (4 * i)));
        if (solid.inverse) {
            is_before = !is_before;
            is_after = !is_after;
        }
        const std::size_t word = std::size_t(solid.place / 64);
        const U bit(1ull << (solid.place % 64));
        batch.before.word[word] = batch.before.word[word] | only(is_before, bit);
        batch.after.word[word] = batch.after.word[word] | only(is_after, bit);
        if (solid.rank < 0) {
            surface.own(once, i, face);
            continue;
        }
        // Solids stand in the order of their ranks.
        before.cover(is_before, solid.rank, face, program_);
        after.cover(is_after, solid.rank, face, program_);
    }
    if (!program_.groups.empty()) list_small_spheres(batch, pivot, reach, torn, before, after);
    batch.unsure = batch.unsure | (batch.met & torn);
    name_owner(batch, surface, before, after);
}

/// The same for small spheres, lane by lane.
HWY_INLINE void Kernel::list_small_spheres(Batch& batch, F pivot, F reach, M& torn, Top& before,
                                           Top& after) {
    batch.sphere_contacts_after = U(0);
    if (batch.near_spheres == 0) return;
    const Doubles at(batch.t), margin(reach), largest(batch.rays.largest), pivots(pivot);
    std::uint32_t doubtful = 0, covered_before = 0, covered_after = 0;
    Doubles rank_before(before.rank), rank_after(after.rank), skipped(batch.false_crossings);
    Words list_before[list_words], list_after[list_words], contacts_after(U(0));
    for (int w = 0; w < program_.words; ++w) {
        list_before[w] = Words(batch.before.word[w]);
        list_after[w] = Words(batch.after.word[w]);
    }
    for_each(batch.near_spheres, [&](std::size_t lane) {
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
            const std::size_t word = std::size_t(stretch.rank / 64);
            const std::uint64_t bit = 1ull << (stretch.rank % 64);
            if (entered && !left) {
                list_before[word][lane] |= bit;
                if (rank_before[lane] < stretch.rank) {
                    rank_before[lane] = stretch.rank;
                    covered_before |= 1u << lane;
                }
            }
            if (entered_after && !left_after) {
                list_after[word][lane] |= bit;
                if (rank_after[lane] < stretch.rank) {
                    rank_after[lane] = stretch.rank;
                    covered_after |= 1u << lane;
                }
            }
            if (enters != leaves) {
                if (contacts == 2) {
                    doubtful |= 1u << lane;
                } else {
                    contacts_after[lane] |= std::uint64_t(stretch.rank + 1) << (32 * contacts++);
                }
            }
            skipped[lane] += (entered && stretch.in > -infinity) + left;
        }
    });
    if (doubtful != 0) torn = torn | mask_of(doubtful);
    batch.sphere_contacts_after = load(contacts_after.at);
    batch.false_crossings = load(skipped.at);
    for (int w = 0; w < program_.words; ++w) {
        batch.before.word[w] = load(list_before[w].at);
        batch.after.word[w] = load(list_after[w].at);
    }
    before.cover(covered_before, rank_before, program_);
    after.cover(covered_after, rank_after, program_);
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
