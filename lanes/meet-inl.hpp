// First stage of a step: where each solid's stretches of the rays lie, and the nearest true
// crossing.

#if defined(MENISCUS_LANES_MEET) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_MEET
#undef MENISCUS_LANES_MEET
#else
#define MENISCUS_LANES_MEET
#endif

#include "lanes/foreign-inl.hpp"
#include "lanes/small_spheres-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

/// Where each solid's stretches of the rays lie, and the nearest crossing that is true.
inline void Kernel::find_stretches(Batch& batch) {
    batch.nearest = F(infinity);
    batch.pivot_magnitude = F(0.0);
    batch.unsure = no_lanes();
    // What is costly is asked last, when it is known how near a crossing must be.
    for (const int i : program_.cheap_first) meet(batch, std::size_t(i));
    if (!program_.groups.empty()) find_small_spheres(batch);
    for (const int i : program_.foreign) meet(batch, std::size_t(i));
}

/// What solid `i` has to say about the rays.
HWY_INLINE void Kernel::meet(Batch& batch, std::size_t i) {
    const Rays& rays = batch.rays;
    const Solid& solid = program_.solids[i];
    const std::size_t word = std::size_t(solid.place / 64);
    const M listed = shares(batch.inside.word[word], U(1ull << (solid.place % 64)));
    const M has_contact = shares(rays.contacts, U(15ull << (4 * i)));
    const M in_shape = solid.inverse ? !listed : listed;
    // What stands in no list is judged by place, but where the ray was born on it.
    const bool is_member = solid.rank >= 0;
    const std::size_t first = 2 * i, end = first + (has_two_stretches(solid.kind) ? 2 : 1);
    Stretch* const stretches = batch.stretches;

    M unsure = no_lanes();
    M unmet = no_lanes();  // lanes that do not come near
    if (is_costly(solid.kind)) {
        const M named = is_member ? in_shape | has_contact : has_contact;
        const M near =
            rays.active & (named | meet_sphere(rays, solid.middle, solid.reach, batch.nearest));
        if (!any(near)) {
            batch.is_near[i] = false;
            for (std::size_t slot = first; slot < end; ++slot)
                stretches[slot].in = stretches[slot].out = F(infinity);
            return;
        }
        unmet = !near;
    }
    if (solid.kind == Kind::lathe) {
        lathe_stretches(program_, solid, rays, is_member ? !no_lanes() : has_contact, in_shape,
                        stretches[first], stretches[first + 1], unsure);
    } else if (solid.kind == Kind::other) {
        const LatheCrossings found = ask_crossings(batch, solid, !unmet, unsure);
        settle(program_, solid, rays, is_member ? !no_lanes() : has_contact, in_shape, found,
               stretches[first], stretches[first + 1], unsure);
    } else {
        Span span;
        switch (solid.kind) {
            case Kind::sphere:
                span = sphere_span(solid, rays, has_contact);
                break;
            case Kind::box:
                span = box_span(solid, rays, contact_of(rays, int(i)));
                break;
            case Kind::cylinder:
                span = cylinder_span(solid, rays, contact_of(rays, int(i)));
                break;
            case Kind::half_space:
                span = half_space_span(solid, rays, has_contact);
                break;
            default:
                span = ask_span(batch, solid, contact_of(rays, int(i)), !unmet);
        }
        const M begins_inside =
            is_member ? in_shape
                      : select_mask(has_contact, in_shape,
                                    span.hit & (span.t0 < F(0.0)) & (F(0.0) < span.t1));
        stretches[first] = resolve(program_, solid, rays, span, begins_inside, has_contact, unsure);
    }
    if (!(solid.to_camera && solid.to_mirrors && solid.to_lights)) {
        if (batch.is_shadow) {
            if (!solid.to_lights) unmet = !no_lanes();
        } else {
            if (!solid.to_camera) unmet = unmet | !batch.is_mirrored;
            if (!solid.to_mirrors) unmet = unmet | batch.is_mirrored;
        }
    }
    if (any(unmet)) {
        unsure = but_not(unsure, unmet);
        for (std::size_t slot = first; slot < end; ++slot) {
            stretches[slot].in = select(unmet, F(infinity), stretches[slot].in);
            stretches[slot].out = select(unmet, F(infinity), stretches[slot].out);
        }
    }
    batch.unsure = batch.unsure | unsure;
    M near = stretches[first].in < F(infinity);
    if (end > first + 1) near = near | (stretches[first + 1].in < F(infinity));
    batch.is_near[i] = any(near);
    if (!batch.is_near[i]) return;

    // To enter and to leave are true crossings where nothing stronger is around.
    M hidden = no_lanes();
    for (std::size_t w = word; is_member && w < std::size_t(program_.words); ++w)
        hidden = hidden | shares(batch.inside.word[w], U(solid.stronger[w]));
    for (std::size_t slot = first; slot < end; ++slot) {
        const Stretch& stretch = stretches[slot];
        const F end_of_way = select(stretch.in == F(-infinity), stretch.out, stretch.in);
        const F crossing = is_member ? select(hidden, F(infinity), end_of_way) : end_of_way;
        if (!program_.one_tolerance)
            batch.pivot_magnitude =
                select(crossing < batch.nearest, F(solid.magnitude), batch.pivot_magnitude);
        batch.nearest = min(crossing, batch.nearest);
    }
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
