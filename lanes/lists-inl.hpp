// Second stage of a step: the event, and what the rays are inside of before and after it.

#if defined(MENISCUS_LANES_LISTS) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_LISTS
#undef MENISCUS_LANES_LISTS
#else
#define MENISCUS_LANES_LISTS
#endif

#include "lanes/kernel-inl.hpp"
#include "lanes/small_sphere_lists-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

/// The event and its lists, from the next crossing with each solid; false if there is a ray for
/// which that is not enough.
HWY_INLINE bool Kernel::list_event(Batch& batch, const Findings& found) {
    const Rays& rays = batch.rays;
    const F nearest = found.nearest.t;
    const F first = max(found.first, F(0.0));
    F next = min(found.second, found.third);
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
    const M doubt = found.doubt | (found.first < rays.sure_start(program_));
    // Most crossings have the place to themselves, and no false ones before them.
    const M alone = (beyond < next) & (t <= first);
    const M crowded = but_not(rays.active, alone);
    // Otherwise solids that are not convex are crossed once at most; small spheres tell all of
    // themselves.
    const M overcrowded = but_not(crowded, beyond < found.third);
    if (any((rays.active & doubt) | overcrowded)) return false;
    if (!any(crowded)) {
        change_lists(batch, found.nearest);
        return true;
    }
    if (cares_for_shades(batch)) return false;
    return program_.words == 1 ? count_together<true>(batch, found.nearest.index)
                               : count_together<false>(batch, found.nearest.index);
}

HWY_INLINE void Kernel::mark_ties(Batch& batch) {
    M both = no_lanes();
    for (const Tie& tie : program_.ties) {
        // Mostly a ray is not even in one before the event and in another after it.
        List either;
        for (int w = 0; w < program_.words; ++w)
            either.word[w] = batch.before.word[w] | batch.after.word[w];
        if (any(are_both(tie, either)))
            both = both | are_both(tie, batch.before) | are_both(tie, batch.after);
    }
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
HWY_INLINE void Kernel::change_lists(Batch& batch, const Crossing& nearest) {
    const M met = batch.met;
    const U index = nearest.index;
    batch.owner_index = index;
    batch.face = nearest.face;
    batch.same = no_lanes();
    batch.by_surface = batch.around->surfaces ? met & is_surface(batch, index) : no_lanes();
    Medium owner = medium_of(index);
    const U place = shift_left(index, 2);
    if (program_.has_faces) {
        // As `contact_word` has it.
        const F face = program_.foreign.empty() ? nearest.face : min(nearest.face, F(14.0));
        batch.contacts = shift_left(as_words(face + F(0x1p52 + 1.0)) & U(15), place);
    } else {
        batch.contacts = shift_left(U(1), place);
    }
    List bit;
    for (int w = 0; w < program_.words; ++w) bit.word[w] = as_words(look_up(table_.bit[w], index));
    if (!program_.groups.empty()) batch.sphere_contacts_after = U(0);
    if (program_.has_meshes)
        batch.mesh_contacts_after = as_words(nearest.face + F(0x1p52 + 1.0)) & U(0xffffffffu);
    if (batch.near_spheres != 0) {
        const M drawn = met & (index == U(is_small_sphere));
        touch_small_spheres(batch, drawn);
        own_by_small_spheres(batch, bits(drawn), owner, bit);
    }
    batch.owner_dressed = owner.dressed;
    change_bits(batch, bit, owner);
}

/// One bit of each list, that of the solid `owner` tells of.
HWY_INLINE void Kernel::change_bits(Batch& batch, const List& bit, const Medium& owner) const {
    const M met = batch.met, by_member = but_not(met, batch.by_surface);
    List others;
    M leaves = no_lanes();
    for (int w = 0; w < program_.words; ++w) {
        const U inside = batch.inside.word[w], own = only(met, bit.word[w]);
        leaves = leaves | shares(inside, own);
        others.word[w] = but_not(inside, own);
        batch.before.word[w] = inside;
        batch.after.word[w] = inside ^ own;
    }
    const Surroundings& around = *batch.around;
    if (around.is_open || around.top != no_rank) {
        batch.medium_before =
            Medium(around.is_open ? program_.outside : program_.members[std::size_t(around.top)]);
        batch.medium_after = select(by_member, owner, batch.medium_before, program_);
        if (const M into_rest = by_member & leaves; any(into_rest))
            batch.medium_after =
                select(into_rest, on_top(batch, others), batch.medium_after, program_);
        return;
    }
    const Medium rest = on_top(batch, others);
    batch.medium_before = select(by_member & leaves, owner, rest, program_);
    batch.medium_after = select(but_not(by_member, leaves), owner, rest, program_);
}

/// What the solids at these indices are made of.
HWY_INLINE Medium Kernel::medium_of(U index) const {
    Medium medium;
    medium.ior = look_up(table_.ior, index);
    if (!program_.ior_tells_medium) medium.medium = look_up(table_.medium, index);
    if (program_.has_dressed) medium.dressed = F(0.0) < look_up(table_.dressed, index);
    if (program_.attenuates) medium.attenuates = F(0.0) < look_up(table_.attenuates, index);
    return medium;
}

/// What the strongest solids of a list are made of.
HWY_INLINE Medium Kernel::on_top(const Batch& batch, const List& list) const {
    Medium medium(program_.outside);
    for (const Listed& solid : listed_)
        medium.become(shares(list.word[solid.word], U(solid.bit)), solid, program_);
    if (batch.near_spheres != 0) {
        Doubles ranks;
        medium.become(covered_by_small_spheres(list, ranks), ranks, program_);
    }
    return medium;
}

/// Whether the solids with these indices stand in no list: they come last.
HWY_INLINE M Kernel::is_surface(const Batch& batch, U index) const {
    if (!program_.has_surfaces) return no_lanes();
    const M late = U(std::uint64_t(program_.listed_solids) - 1) < index;
    return batch.near_spheres == 0 ? late : but_not(late, index == U(is_small_sphere));
}

/// What has a say in the tolerance at an event: the larger of two magnitudes, its own and
/// another's.
HWY_INLINE F Kernel::bounds_of_event(const Batch& batch, U index, F& pivot) const {
    pivot =
        program_.one_tolerance ? F(program_.largest_magnitude) : nearest_magnitude(batch, index);
    return max(F(1e-7) * (batch.rays.largest + batch.t + pivot),
               F(100.0 * program_.contact_tolerance));
}

/// The lists where each solid is crossed once at most about the event: what lies within the
/// tolerance of it counts together. False if one is crossed twice there.
template <bool one_word>
bool Kernel::count_together(Batch& batch, U nearest) {
    const int words = one_word ? 1 : program_.words;
    const Rays& rays = batch.rays;
    const F t = batch.t;
    F pivot;
    const F reach = bounds_of_event(batch, nearest, pivot);
    const F units(program_.tolerance_units * unit_roundoff), least(program_.contact_tolerance);
    const F far = rays.largest + t;
    const F common = max(units * (far + pivot), least);
    F low = t - common, high = t + common;
    List before_list, after_list;
    for (int w = 0; w < words; ++w) before_list.word[w] = after_list.word[w] = batch.inside.word[w];
    Owner surface;
    U contacts(0), mesh_contacts(0);
    F passes(0.0);
    M torn = no_lanes();
    for (const int index : batch.around->all) {
        const auto i = std::size_t(index);
        const Solid& solid = program_.solids[i];
        if (!program_.one_tolerance) {
            const F tolerance = max(units * (far + max(pivot, F(solid.magnitude))), least);
            low = t - tolerance;
            high = t + tolerance;
        }
        const F at = max(batch.crossing[i], F(0.0)), beyond = high + reach;
        // What is crossed farther behind the event has no say.
        if (!any(rays.active & (at <= beyond))) continue;
        const M passed = at < low, reached = at <= high;
        const M touches = but_not(reached, passed);
        torn = torn | (touches ^ (abs(at - t) <= reach));
        M reached_once = reached, passed_once = passed;
        if (any(passed)) {
            batch.has_passed = true;
            passes = passes + only(passed, F(1.0));
        }
        if (has_end(solid)) {
            const F end = batch.crossing_end[i];
            const M ends = rays.active & (end <= beyond);
            if (any(ends)) {
                // A solid that is entered and left again on the way.
                const M left = end < low - reach;
                if (any(but_not(ends, left))) return false;
                passes = passes + only(left, F(1.0));
                reached_once = but_not(reached, left);
                passed_once = but_not(passed, left);
            }
        }
        const F face = has_faces(solid.kind) ? batch.crossing_face[i] : F(0.0);
        contacts = contacts | only(touches, contact_word(solid, face, i));
        if (solid.way == Way::mesh) touch_mesh(mesh_contacts, touches, face, torn);
        const std::size_t word = one_word ? 0 : std::size_t(solid.place / 64);
        const U bit(1ull << (solid.place % 64));
        before_list.word[word] = before_list.word[word] ^ only(passed_once, bit);
        after_list.word[word] = after_list.word[word] ^ only(reached_once, bit);
        if (solid.rank < 0) surface.own(touches, i, face);
    }
    batch.contacts = contacts;
    if (program_.has_meshes) batch.mesh_contacts_after = mesh_contacts;
    batch.false_crossings = passes;
    for (int w = 0; w < words; ++w) {
        const U grouped(group_bits_[w]);
        batch.before.word[w] = but_not(before_list.word[w], grouped);
        batch.after.word[w] = but_not(after_list.word[w], grouped);
    }
    if (!program_.groups.empty()) list_small_spheres(batch, pivot, reach, torn);
    batch.unsure = batch.unsure | (batch.met & torn);
    name_owner(batch, surface);
    return true;
}

/// Whose surface the event is, if no surface of its own has it: that of the stronger of the two
/// solids on top, so of the strongest in either list. And what is on both sides.
HWY_INLINE void Kernel::name_owner(Batch& batch, const Owner& surface) const {
    const M met = batch.met;
    List either;
    for (int w = 0; w < program_.words; ++w)
        either.word[w] =
            (batch.before.word[w] | batch.after.word[w]) & U(program_.member_bits[std::size_t(w)]);
    U index(is_small_sphere);
    F face(0.0);
    for (std::size_t i = 0; i < listed_.size(); ++i) {
        const Listed& solid = listed_[i];
        const M owns = shares(either.word[solid.word], U(solid.bit));
        index = select(owns, U(i), index);
        if (program_.has_faces)
            face =
                solid.has_faces ? select(owns, batch.crossing_face[i], face) : but_not(owns, face);
    }
    Medium owner = medium_of(index);
    List bit;
    for (int w = 0; w < program_.words; ++w) bit.word[w] = as_words(look_up(table_.bit[w], index));
    if (batch.near_spheres != 0) {
        const std::uint32_t covered = covered_by_small_spheres(either, batch.sphere_ranks);
        const M by_small = mask_of(covered);
        index = select(by_small, U(is_small_sphere), index);
        face = but_not(by_small, face);
        own_by_small_spheres(batch, covered, owner, bit);
    }
    M before_owns = no_lanes(), after_owns = before_owns;
    for (int w = 0; w < program_.words; ++w) {
        before_owns = before_owns | shares(batch.before.word[w], bit.word[w]);
        after_owns = after_owns | shares(batch.after.word[w], bit.word[w]);
    }
    // The other list's.
    List other;
    for (int w = 0; w < program_.words; ++w)
        other.word[w] = select(after_owns, batch.before.word[w], batch.after.word[w]);
    const Medium rest = on_top(batch, other);
    batch.medium_before = select(before_owns, owner, rest, program_);
    batch.medium_after = select(after_owns, owner, rest, program_);
    batch.by_surface = surface.which & met;
    batch.same = but_not(but_not(met, batch.by_surface), before_owns ^ after_owns);
    batch.owner_dressed = owner.dressed;
    batch.face = select(batch.by_surface, surface.face, face);
    batch.owner_index = select(batch.by_surface, surface.index, index);
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
