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
    return shift_left(as_words(with_exponent) & U(15), 4 * index);
}

/// The event: the nearest true crossing, what coincides with it, and the lists just before and
/// just after.
inline void Kernel::find_event(Batch& batch) {
    batch.met = batch.rays.active & (batch.nearest < F(infinity));
    if (batch.is_shadow) batch.met = batch.met & (batch.nearest <= batch.rays.t_max);
    batch.t = select(batch.met, batch.nearest, min(batch.rays.t_max, F(1e300)));
    // Most crossings have the place to themselves. Then all bounds give the same lists, and a
    // coarse one will do; where that fails often it is not tried.
    if (crowded_ < most_crowded) {
        if (make_lists<false>(batch)) return;
        crowded_ += crowded_cost;
    } else {
        --crowded_;
    }
    make_lists<true>(batch);
}

/// The rays that are inside of two kinds of a tie.
HWY_INLINE M Kernel::are_both(const Tie& tie, const List& list) const {
    M one = no_lanes(), two = one;
    for (const Places& kind : tie.kinds) {
        M inside = no_lanes();
        for (int w = 0; w < program_.words; ++w)
            inside = inside | shares(list.word[w], U(kind[std::size_t(w)]));
        two = two | (one & inside);
        one = one | inside;
    }
    return two;
}

/// With `exact` bounds, or with one coarse bound for all: false if then more than one crossing lies
/// within it.
template <bool exact>
HWY_INLINE bool Kernel::make_lists(Batch& batch) {
    Top before(program_.outside), after(program_.outside);
    const Rays& rays = batch.rays;
    const F t = batch.t;
    for (int w = 0; w < program_.words; ++w) batch.before.word[w] = batch.after.word[w] = U(0);
    batch.contacts = U(0);
    batch.surface = F(double(no_rank));
    batch.surface_face = F(0.0);
    batch.false_crossings = F(0.0);
    const F units(program_.tolerance_units * unit_roundoff), least(program_.contact_tolerance);
    const F largest(program_.largest_magnitude);
    const F pivot = program_.one_tolerance ? largest : batch.pivot_magnitude;
    const F far = rays.largest + t;
    const F reach = max(F(1e-7) * (far + (exact ? pivot : largest)), F(100.0) * least);
    const F common = exact ? max(units * (far + pivot), least) : reach;
    F low = t - common, high = t + common;
    M torn = no_lanes();
    M crossed = but_not(rays.active, batch.met), crowded = no_lanes();
    for (std::size_t i = 0; i < program_.solids.size(); ++i) {
        const Solid& solid = program_.solids[i];
        if (!batch.is_near[i] && !solid.inverse) continue;  // nowhere before, nowhere after
        if (exact && !program_.one_tolerance) {
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
            if constexpr (exact) {
                torn = torn | (enters ^ (abs(stretch.in - t) <= reach)) |
                       (leaves ^ (abs(stretch.out - t) <= reach));
            } else {
                const M crosses = enters | leaves;
                crowded = crowded | (crossed & crosses) | (enters & leaves);
                crossed = crossed | crosses;
            }
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
            batch.surface = select(once, F(double(i)), batch.surface);
            batch.surface_face = select(once, face, batch.surface_face);
            continue;
        }
        // Solids stand in the order of their ranks.
        before.cover(is_before, solid.rank, program_);
        after.cover(is_after, solid.rank, program_);
        if (has_faces(solid.kind)) {
            before.face = select(is_before, face, before.face);
            after.face = select(is_after, face, after.face);
        }
    }
    if (!exact && any(rays.active & crowded)) return false;
    if (!program_.groups.empty()) {
        const M more =
            list_small_spheres<exact>(batch, low, high, pivot, reach, crossed, torn, before, after);
        if (!exact && any(more)) return false;
    }
    for (const Tie& tie : program_.ties)
        torn = torn | are_both(tie, batch.before) | are_both(tie, batch.after);
    batch.unsure = rays.active & (batch.unsure | (batch.met & torn));
    batch.before_top = before;
    batch.after_top = after;
    return true;
}

/// The same for small spheres, lane by lane: lanes with more than one crossing within a coarse
/// bound, or `torn` by exact ones.
template <bool exact>
HWY_INLINE M Kernel::list_small_spheres(Batch& batch, F low_bound, F high_bound, F pivot, F reach,
                                        M crossed, M& torn, Top& before, Top& after) {
    batch.sphere_contacts_after = U(0);
    if (batch.near_spheres == 0) return no_lanes();
    const Doubles at(batch.t), margin(reach), largest(batch.rays.largest), pivots(pivot),
        lows(low_bound), highs(high_bound);
    std::uint32_t doubtful = 0, covered_before = 0, covered_after = 0, crowded = 0;
    const std::uint32_t others = bits(crossed);
    Doubles rank_before(before.rank), rank_after(after.rank), skipped(batch.false_crossings);
    Words list_before[list_words], list_after[list_words], contacts_after(U(0));
    for (int w = 0; w < program_.words; ++w) {
        list_before[w] = Words(batch.before.word[w]);
        list_after[w] = Words(batch.after.word[w]);
    }
    for_each(batch.near_spheres, [&](std::size_t lane) {
        const SphereStretches& list = batch.spheres[lane];
        int contacts = 0, crossings = int(others >> lane & 1u);
        for (int k = 0; k < list.size; ++k) {
            const SphereStretch& stretch = list.at[k];
            double low = lows[lane], high = highs[lane];
            if constexpr (exact) {
                const double tolerance =
                    std::max(program_.tolerance_units * unit_roundoff *
                                 (largest[lane] + at[lane] +
                                  std::max(pivots[lane], magnitudes_[std::size_t(stretch.rank)])),
                             program_.contact_tolerance);
                low = at[lane] - tolerance;
                high = at[lane] + tolerance;
            }
            const bool entered = stretch.in < low, entered_after = stretch.in <= high;
            const bool left = stretch.out < low, left_after = stretch.out <= high;
            const bool enters = entered != entered_after, leaves = left != left_after;
            if constexpr (exact) {
                if (enters != (std::abs(stretch.in - at[lane]) <= margin[lane]) ||
                    leaves != (std::abs(stretch.out - at[lane]) <= margin[lane]))
                    doubtful |= 1u << lane;
            } else {
                crossings += enters + leaves;
            }
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
        if (crossings > 1) crowded |= 1u << lane;
    });
    if (crowded != 0) return mask_of(crowded);
    if (doubtful != 0) torn = torn | mask_of(doubtful);
    batch.sphere_contacts_after = load(contacts_after.at);
    batch.false_crossings = load(skipped.at);
    for (int w = 0; w < program_.words; ++w) {
        batch.before.word[w] = load(list_before[w].at);
        batch.after.word[w] = load(list_after[w].at);
    }
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
        if (!program_.ior_tells_medium) top.medium = load(media.at);
        if (program_.has_dressed) top.dressed = mask_of(dressed);
        if (program_.attenuates) top.attenuates = mask_of(attenuates);
    };
    cover(covered_before, rank_before, before);
    cover(covered_after, rank_after, after);
    return no_lanes();
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
