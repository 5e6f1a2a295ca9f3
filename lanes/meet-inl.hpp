// Where each solid's whole stretches of the rays lie, for steps with a ray that needs them all.

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
void Kernel::find_stretches(Batch& batch, Findings& found) {
    batch.unsure = no_lanes();
    batch.near_spheres = 0;
    // What is costly is asked last, when it is known how near a crossing must be.
    for (const int i : program_.cheap_first) {
        if (is_plain_floor(program_.solids[std::size_t(i)])) {
            meet_floor(batch, found, std::size_t(i));
        } else {
            meet(batch, found, std::size_t(i));
        }
    }
    if (!program_.groups.empty() && !cares_for_shades(batch)) find_small_spheres(batch, found);
    for (const int i : program_.foreign) meet(batch, found, std::size_t(i));
}

/// What solid `i` has to say about the rays: its stretches; whether there are any.
inline bool Kernel::ask(Batch& batch, F nearest, std::size_t i) {
    const Rays& rays = batch.rays;
    const Solid& solid = program_.solids[i];
    if (solid.way == Way::mesh) return batch.is_near[i];  // they are asked once
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
            rays.active & (named | meet_sphere(program_, rays, solid.middle, solid.reach, nearest));
        if (!any(near)) {
            batch.is_near[i] = false;
            for (std::size_t slot = first; slot < end; ++slot)
                stretches[slot].in = stretches[slot].out = F(infinity);
            return false;
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
        stretches[first].face_in = span.face0;
        stretches[first].face_out = span.face1;
    }
    if (!(solid.to_camera && solid.to_mirrors && solid.to_lights) || cares_for_shades(batch))
        unmet = unmet | !sees(batch, solid);
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
    return batch.is_near[i];
}

/// The rays that the solid is there for.
HWY_INLINE M Kernel::sees(const Batch& batch, const Solid& solid) const {
    if (batch.is_shadow) {
        const bool is_seen = solid.to_lights && !(cares_for_shades(batch) && solid.rank >= 0);
        return is_seen ? !no_lanes() : no_lanes();
    }
    M result = !no_lanes();
    if (!solid.to_camera) result = result & batch.is_mirrored;
    if (!solid.to_mirrors) result = but_not(result, batch.is_mirrored);
    return result;
}

/// Solid `i`, by its whole stretches.
HWY_INLINE void Kernel::meet(Batch& batch, Findings& found, std::size_t i) {
    if (!ask(batch, found.nearest.t, i)) return;
    const Solid& solid = program_.solids[i];
    const M hidden = solid.rank >= 0 ? hidden_from(batch, solid) : no_lanes();
    for (std::size_t slot = 2 * i; slot < 2 * i + (has_two_stretches(solid.kind) ? 2 : 1); ++slot)
        offer(found, i, batch.stretches[slot], hidden);
}

/// To enter and to leave are true crossings where nothing stronger is around.
HWY_INLINE M Kernel::hidden_from(const Batch& batch, const Solid& solid) const {
    M hidden = no_lanes();
    for (auto w = std::size_t(solid.place / 64); w < std::size_t(program_.words); ++w)
        hidden = hidden | shares(batch.inside.word[w], U(solid.stronger[w]));
    return hidden;
}

/// Half-spaces that stand in no list: no chord of theirs is thin, and where a ray was not born on
/// them its place tells on which side it is.
HWY_INLINE void Kernel::meet_floor(Batch& batch, Findings& found, std::size_t i) {
    const Rays& rays = batch.rays;
    const Solid& solid = program_.solids[i];
    const M listed = shares(batch.inside.word[solid.place / 64], U(1ull << (solid.place % 64)));
    const M has_contact = shares(rays.contacts, U(15ull << (4 * i)));
    const F3 n(solid.center);
    const F slope = dot(rays.world.direction, n);
    const F depth = F(solid.distance) - dot(rays.world.origin, n);
    const M inside = select_mask(has_contact, listed, F(0.0) < depth);
    const F t = max(but_not(has_contact, depth / slope), F(0.0));
    Stretch& stretch = batch.stretches[2 * i];
    stretch.in = select(inside, F(-infinity), select(slope < F(0.0), t, F(infinity)));
    stretch.out = select(inside & (F(0.0) < slope), t, F(infinity));
    batch.is_near[i] = any(stretch.in < F(infinity));
    if (batch.is_near[i]) offer(found, i, stretch, no_lanes());
}

/// Where a ray comes to a stretch, or to the end of the one that it starts in.
HWY_INLINE void Kernel::offer(Findings& found, std::size_t i, const Stretch& stretch, M hidden) {
    const F t = select(stretch.in == F(-infinity), stretch.out, stretch.in);
    const M nearer = but_not(t < found.nearest.t, hidden);
    found.nearest.t = select(nearer, t, found.nearest.t);
    found.nearest.index = select(nearer, U(i), found.nearest.index);
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
