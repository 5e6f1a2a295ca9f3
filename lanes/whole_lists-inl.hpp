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
    const Rays& rays = batch.rays;
    const F t = batch.t;
    for (int w = 0; w < program_.words; ++w) batch.before.word[w] = batch.after.word[w] = U(0);
    batch.contacts = U(0);
    U mesh_contacts(0);
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
        if (has_faces(solid.kind)) batch.crossing_face[i] = face;
        batch.contacts = batch.contacts | only(once, contact_word(solid, face, i));
        if (solid.way == Way::mesh) touch_mesh(mesh_contacts, once, face, torn);
        if (solid.inverse) {
            is_before = !is_before;
            is_after = !is_after;
        }
        const std::size_t word = std::size_t(solid.place / 64);
        const U bit(1ull << (solid.place % 64));
        batch.before.word[word] = batch.before.word[word] | only(is_before, bit);
        batch.after.word[word] = batch.after.word[word] | only(is_after, bit);
        if (solid.rank < 0) surface.own(once, i, face);
    }
    if (program_.has_meshes) batch.mesh_contacts_after = mesh_contacts;
    if (!program_.groups.empty()) list_small_spheres(batch, pivot, reach, torn);
    batch.unsure = batch.unsure | (batch.met & torn);
    name_owner(batch, surface);
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
