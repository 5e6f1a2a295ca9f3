// Second stage of a step: the event, and what the rays are inside of before and after it.

#if defined(MENISCUS_LANES_LISTS) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_LISTS
#undef MENISCUS_LANES_LISTS
#else
#define MENISCUS_LANES_LISTS
#endif

#include "lanes/kernel-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

/// The event and its lists, from the next crossing with each solid; false if there is a ray for
/// which that is not enough.
inline bool Kernel::list_event(Batch& batch) {
    const Rays& rays = batch.rays;
    const F nearest = batch.nearest.t;
    const F first = max(batch.first, F(0.0));
    F next = min(batch.second, batch.ends);
    M met = rays.active & (nearest < F(infinity));
    F t = min(max(nearest, F(0.0)), F(1e300));
    if (batch.is_shadow) {
        met = met & (nearest <= rays.t_max);
        t = select(met, t, min(rays.t_max, F(1e300)));
        next = select(met, next, min(first, next));
    }
    batch.met = met;
    batch.t = t;
    const F reach = max(F(1e-7) * (rays.largest + t + F(program_.largest_magnitude)),
                        F(100.0 * program_.contact_tolerance));
    const F beyond = t + reach;
    // Before the start by more than rounding lies nothing: there list and place would disagree.
    const M doubt = batch.doubt | (batch.first < rays.sure_start);
    // Most crossings have the place to themselves, and no false ones before them.
    const M alone = (beyond < next) & (t <= first);
    const M crowded = but_not(rays.active, alone);
    // Otherwise each solid is crossed once at most, and no small sphere.
    const M overcrowded = but_not(crowded, beyond < min(batch.ends, batch.sphere_first));
    if (any((rays.active & doubt) | overcrowded)) return false;
    if (any(crowded)) {
        count_together(batch, reach);
    } else {
        change_lists(batch);
    }
    return true;
}

HWY_INLINE void Kernel::mark_ties(Batch& batch) {
    M both = no_lanes();
    for (const Tie& tie : program_.ties)
        both = both | are_both(tie, batch.before) | are_both(tie, batch.after);
    batch.unsure = batch.rays.active & (batch.unsure | (batch.met & both));
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

/// The lists where the event is all that happens on the way: one bit comes or goes.
HWY_INLINE void Kernel::change_lists(Batch& batch) {
    const Crossing& nearest = batch.nearest;
    const M met = batch.met;
    const U index = nearest.index;
    batch.owner_index = index;
    M by_member = met;
    batch.surface = F(double(no_rank));
    if (program_.has_surfaces) {
        const M by_surface = met & (F(0.0) < look_up(table_.surface, index));
        by_member = but_not(met, by_surface);
        batch.surface = select(by_surface, to_double(index), batch.surface);
    }
    Top owner(program_.outside), top = owner;
    owner.rank = look_up(table_.rank, index);
    owner.ior = look_up(table_.ior, index);
    if (!program_.ior_tells_medium) owner.medium = look_up(table_.medium, index);
    if (program_.has_dressed) owner.dressed = F(0.0) < look_up(table_.dressed, index);
    if (program_.attenuates) owner.attenuates = F(0.0) < look_up(table_.attenuates, index);
    batch.contacts = shift_left(as_words(min(nearest.face + F(1.0), F(15.0)) + F(0x1p52)) & U(15),
                                shift_left(index, 2));
    List bit;
    for (int w = 0; w < program_.words; ++w) bit.word[w] = as_words(look_up(table_.bit[w], index));
    batch.sphere_contacts_after = U(0);
    if (batch.near_spheres != 0) own_by_small_spheres(batch, &owner, bit);

    List rest;
    M leaves = no_lanes();
    for (int w = 0; w < program_.words; ++w) {
        const U inside = batch.inside.word[w], own = only(met, bit.word[w]);
        leaves = leaves | shares(inside, own);
        rest.word[w] = but_not(inside, own);
        batch.before.word[w] = inside;
        batch.after.word[w] = inside ^ own;
    }
    for (const Solid& solid : program_.solids) {
        if (solid.rank < 0) continue;
        top.cover(shares(rest.word[solid.place / 64], U(1ull << (solid.place % 64))), solid.rank,
                  program_);
    }
    if (!program_.groups.empty()) cover_by_small_spheres(rest, top);
    batch.before_top = select(by_member & leaves, owner, top, program_);
    batch.after_top = select(but_not(by_member, leaves), owner, top, program_);
    batch.before_top.face = batch.after_top.face = batch.surface_face = nearest.face;
    batch.false_crossings = F(0.0);
}

/// What has a say in the tolerance at an event: the larger of two magnitudes, its own and
/// another's.
HWY_INLINE F Kernel::bounds_of_event(const Batch& batch, F& pivot) const {
    pivot = program_.one_tolerance ? F(program_.largest_magnitude) : nearest_magnitude(batch);
    return max(F(1e-7) * (batch.rays.largest + batch.t + pivot),
               F(100.0 * program_.contact_tolerance));
}

/// The lists where each solid is crossed once at most up to behind the event: what lies within the
/// tolerance of it counts together.
inline void Kernel::count_together(Batch& batch, F) {
    const Rays& rays = batch.rays;
    const F t = batch.t;
    F pivot;
    const F reach = bounds_of_event(batch, pivot);
    const F units(program_.tolerance_units * unit_roundoff), least(program_.contact_tolerance);
    const F far = rays.largest + t;
    const F common = max(units * (far + pivot), least);
    F low = t - common, high = t + common;
    batch.contacts = U(0);
    batch.surface = F(double(no_rank));
    batch.surface_face = F(0.0);
    batch.false_crossings = F(0.0);
    for (int w = 0; w < program_.words; ++w)
        batch.before.word[w] = batch.after.word[w] = batch.inside.word[w];
    batch.sphere_contacts_after = U(0);
    if (batch.near_spheres != 0) {
        List own;
        for (int w = 0; w < program_.words; ++w) own.word[w] = U(0);
        own_by_small_spheres(batch, nullptr, own);
        for (int w = 0; w < program_.words; ++w)
            batch.after.word[w] = batch.after.word[w] ^ own.word[w];
        batch.contacts = U(0);
    }
    Top before(program_.outside), after(program_.outside);
    M torn = no_lanes();
    for (std::size_t i = 0; i < program_.solids.size(); ++i) {
        const Solid& solid = program_.solids[i];
        if (!program_.one_tolerance) {
            const F tolerance = max(units * (far + max(pivot, F(solid.magnitude))), least);
            low = t - tolerance;
            high = t + tolerance;
        }
        const F at = max(batch.crossing[i], F(0.0));
        const M passed = at < low, reached = at <= high;
        const M touches = but_not(reached, passed);
        torn = torn | (touches ^ (abs(at - t) <= reach));
        if (any(passed)) batch.false_crossings = batch.false_crossings + only(passed, F(1.0));
        const F face = has_faces(solid.kind) ? only(touches, batch.crossing_face[i]) : F(0.0);
        batch.contacts =
            batch.contacts |
            only(touches, has_faces(solid.kind) ? contact_word(face, int(i)) : U(1ull << (4 * i)));
        const std::size_t word = std::size_t(solid.place / 64);
        const U bit(1ull << (solid.place % 64));
        batch.before.word[word] = batch.before.word[word] ^ only(passed, bit);
        batch.after.word[word] = batch.after.word[word] ^ only(reached, bit);
        if (solid.rank < 0) {
            batch.surface = select(touches, F(double(i)), batch.surface);
            batch.surface_face = select(touches, face, batch.surface_face);
            continue;
        }
        // Solids stand in the order of their ranks.
        const M is_before = shares(batch.before.word[word], bit),
                is_after = shares(batch.after.word[word], bit);
        before.cover(is_before, solid.rank, program_);
        after.cover(is_after, solid.rank, program_);
        if (has_faces(solid.kind)) {
            before.face = select(is_before, face, before.face);
            after.face = select(is_after, face, after.face);
        }
    }
    if (!program_.groups.empty()) {
        cover_by_small_spheres(batch.before, before);
        cover_by_small_spheres(batch.after, after);
    }
    batch.unsure = batch.unsure | (batch.met & torn);
    batch.before_top = before;
    batch.after_top = after;
    name_owner(batch);
}

/// Whose surface the event is.
HWY_INLINE void Kernel::name_owner(Batch& batch) const {
    batch.owner_index = U(is_small_sphere);
    const F owner = max(batch.before_top.rank, batch.after_top.rank);
    for (std::size_t i = 0; i < program_.solids.size(); ++i) {
        const Solid& solid = program_.solids[i];
        const M here =
            solid.rank >= 0 ? owner == F(double(solid.rank)) : batch.surface == F(double(i));
        batch.owner_index = select(here, U(i), batch.owner_index);
    }
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
