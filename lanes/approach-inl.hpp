// First stage of a step: how far the rays come until each solid's next crossing, and the nearest
// that is true.

#if defined(MENISCUS_LANES_APPROACH) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_APPROACH
#undef MENISCUS_LANES_APPROACH
#else
#define MENISCUS_LANES_APPROACH
#endif

#include "lanes/meet-inl.hpp"
#include "lanes/mesh-inl.hpp"
#include "lanes/near_lathe-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

/// The next crossing with each solid. Lanes for which that is not enough are marked `doubt`.
HWY_INLINE void Kernel::approach(Batch& batch, Findings& found) {
    batch.unsure = no_lanes();
    batch.near_spheres = 0;
    if (cares_for_shades(batch)) return approach_shades(batch, found);
    const Surroundings& around = *batch.around;
    for (const int i : around.balls) approach_ball(batch, found, std::size_t(i));
    for (const int i : around.others) {
        const Solid& solid = program_.solids[std::size_t(i)];
        switch (solid.way) {
            case Way::ball:
                break;
            case Way::floor:
                approach_floor(batch, found, std::size_t(i));
                break;
            case Way::cylinder:
                approach_cylinder(batch, found, std::size_t(i));
                break;
            case Way::box:
                approach_box(batch, found, std::size_t(i));
                break;
            case Way::cup:
            case Way::stepped_lathe:
                approach_lathe(batch, found, std::size_t(i));
                break;
            case Way::mesh:
                break;
            case Way::any:
                approach_any(batch, found, std::size_t(i));
        }
    }
    if (around.small_spheres) find_small_spheres(batch, found);
    for (const int i : around.foreign) approach_any(batch, found, std::size_t(i));
    if (program_.has_meshes) approach_meshes(batch, found);
}

/// What alone keeps light away, where all else lets it through as it is. Others' crossings are not
/// told: where more than one may count, `list_event` leaves that to the whole stretches.
HWY_INLINE void Kernel::approach_shades(Batch& batch, Findings& found) {
    for (const int i : program_.shades) {
        switch (program_.solids[std::size_t(i)].way) {
            case Way::floor:
                approach_floor(batch, found, std::size_t(i));
                break;
            case Way::mesh:
                break;
            default:
                approach_any(batch, found, std::size_t(i));
        }
    }
    if (program_.has_meshes) approach_meshes(batch, found);
}

/// The most frequent solid: a sphere that stands in the list, is where it was made and that all
/// rays see.
HWY_INLINE void Kernel::approach_ball(Batch& batch, Findings& found, std::size_t i) {
    const Rays& rays = batch.rays;
    const Solid& solid = program_.solids[i];
    const M inside = shares(batch.inside.word[solid.place / 64], U(1ull << (solid.place % 64)));
    const M has_contact = shares(rays.contacts, U(15ull << (4 * i)));
    const F3 e = rays.world.origin - F3(solid.center);
    const F b = dot(e, rays.world.direction);
    const F half = ball_half(solid, rays.world, e, b, has_contact);
    const F t0 = -b - half, t1 = half - b;
    // The chord is at least so long.
    const F chord = min(half, t1);
    const M enters = but_not(F(0.0) < chord, inside);
    found.doubt = found.doubt | (enters & (chord < rays.thin() + F(solid.thin)));
    const F end = select(enters, t1, F(infinity));
    batch.crossing_end[i] = end;
    found.second = min(found.second, end);
    const F t = select(inside, t1, select(enters, t0, F(infinity)));
    come_to(batch, found, solid, i, t, F(0.0));
}

/// Half-spaces that stand in no list: where a ray was not born on them its place tells on which
/// side it is.
HWY_INLINE void Kernel::approach_floor(Batch& batch, Findings& found, std::size_t i) {
    const Rays& rays = batch.rays;
    const Solid& solid = program_.solids[i];
    U& word = batch.inside.word[solid.place / 64];
    const U bit(1ull << (solid.place % 64));
    const M has_contact = shares(rays.contacts, U(15ull << (4 * i)));
    const F3 n(solid.center);
    const F slope = dot(rays.world.direction, n);
    const F depth = F(solid.distance) - dot(rays.world.origin, n);
    const M inside = select_mask(has_contact, shares(word, bit), F(0.0) < depth);
    word = but_not(word, bit) | only(inside, bit);
    const M crosses = select_mask(inside, F(0.0) < slope, slope < F(0.0));
    const F t = select(crosses, max(but_not(has_contact, depth / slope), F(0.0)), F(infinity));
    come_to(batch, found, solid, i, t, F(0.0));
}

/// What a convex solid's span means to rays, of which some start `inside`.
HWY_INLINE void Kernel::come_to_span(Batch& batch, Findings& found, const Solid& solid,
                                     std::size_t i, M inside, F t0, F t1, M exists, F face) {
    const F chord = min(t1 - t0, t1);
    const M enters = but_not(exists & (F(0.0) < chord), inside);
    found.doubt = found.doubt | (enters & (chord < batch.rays.thin() + F(solid.thin)));
    const F end = select(enters, t1, F(infinity));
    batch.crossing_end[i] = end;
    found.second = min(found.second, end);
    const F t = select(inside, t1, select(enters, t0, F(infinity)));
    come_to(batch, found, solid, i, t, face);
}

/// Cylinders that stand in the list and that all rays see, where they were made.
HWY_INLINE void Kernel::approach_cylinder(Batch& batch, Findings& found, std::size_t i) {
    const Rays& rays = batch.rays;
    const Solid& solid = program_.solids[i];
    const M inside = shares(batch.inside.word[solid.place / 64], U(1ull << (solid.place % 64)));
    const U contact = rays.contacts & U(15ull << (4 * i));
    const auto is_on = [&](std::uint64_t face)
                           HWY_ATTR { return contact == U((face + 1) << (4 * i)); };
    const F3& d = rays.world.direction;
    const F3 e = rays.world.origin - F3(solid.center);
    F along_e, along_d, dd, b, distance2;
    if (solid.axis == geom::Vec3{0.0, 1.0, 0.0}) {  // the same without what is 0
        along_e = e.y;
        along_d = d.y;
        dd = d.x * d.x + d.z * d.z;
        b = (d.x * e.x + d.z * e.z) * (F(1.0) / dd);
        const F x = e.x - b * d.x, z = e.z - b * d.z;
        distance2 = x * x + z * z;
    } else {
        const F3 axis(solid.axis);
        along_e = dot(e, axis);
        along_d = dot(d, axis);
        const F3 across_e = e - along_e * axis, across_d = d - along_d * axis;
        dd = dot(across_d, across_d);
        b = dot(across_d, across_e) * (F(1.0) / dd);
        const F3 f = across_e - b * across_d;
        distance2 = dot(f, f);
    }
    // The side; a ray born on it meets it there and at twice the middle.
    const F discriminant = (F(solid.radius * solid.radius) - distance2) * (F(1.0) / dd);
    const F half = select(is_on(0), abs(b), sqrt(max(discriminant, F(0.0))));
    const F low = -b - half, high = half - b;
    // The caps.
    const F inverse = F(1.0) / along_d;
    const F at_base = but_not(is_on(1), -along_e * inverse);
    const F at_cap = but_not(is_on(2), (F(solid.length) - along_e) * inverse);
    const M upwards = F(0.0) < along_d;
    const F near = select(upwards, at_base, at_cap), far = select(upwards, at_cap, at_base);
    // Next to an axis' direction and across it the general way decides.
    found.doubt = found.doubt | (along_d == F(0.0)) | (dd < F(1e-30));
    const F t0 = max(near, low), t1 = min(far, high);
    const M is_flat = select_mask(inside, far <= high, low <= near);
    const F face = only(is_flat, select(inside ^ upwards, F(1.0), F(2.0)));
    come_to_span(batch, found, solid, i, inside, t0, t1, (F(0.0) < half) & (t0 < t1), face);
}

/// Boxes, in whatever frame, that stand in the list and that all rays see.
HWY_INLINE void Kernel::approach_box(Batch& batch, Findings& found, std::size_t i) {
    const Rays& rays = batch.rays;
    const Solid& solid = program_.solids[i];
    const M inside = shares(batch.inside.word[solid.place / 64], U(1ull << (solid.place % 64)));
    const U contact = rays.contacts & U(15ull << (4 * i));
    const M near =
        rays.active & (inside | !(contact == U(0)) |
                       meet_sphere(program_, rays, solid.middle, solid.reach, found.nearest.t));
    if (!any(near)) {
        batch.crossing[i] = batch.crossing_end[i] = F(infinity);
        return;
    }
    Line scratch;
    const Line& ray = local(solid, rays, scratch);
    const F origin[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
    const F direction[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
    F t0(-infinity), t1(infinity), face(0.0);
    M doubt = no_lanes();
    for (int axis = 0; axis < 3; ++axis) {
        const std::uint64_t low = std::uint64_t(2 * axis), high = low + 1;
        const M on_low = contact == U((low + 1) << (4 * i)),
                on_high = contact == U((high + 1) << (4 * i));
        const F inverse = F(1.0) / direction[axis];
        const F at_low = but_not(on_low, (F(solid.low[axis]) - origin[axis]) * inverse);
        const F at_high = but_not(on_high, (F(solid.high[axis]) - origin[axis]) * inverse);
        doubt = doubt | (direction[axis] == F(0.0));
        const M upwards = F(0.0) < direction[axis];
        const F in = select(upwards, at_low, at_high), out = select(upwards, at_high, at_low);
        const M decides = select_mask(inside, out < t1, t0 < in);
        face = select(decides, select(inside ^ upwards, F(double(low)), F(double(high))), face);
        t0 = max(t0, in);
        t1 = min(t1, out);
    }
    found.doubt = found.doubt | (near & doubt);
    come_to_span(batch, found, solid, i, inside, t0, t1, near & (t0 < t1), face);
}

/// Lathes of rings and cylinders that stand in the list and that all rays see.
HWY_INLINE void Kernel::approach_lathe(Batch& batch, Findings& found, std::size_t i) {
    const Rays& rays = batch.rays;
    const Solid& solid = program_.solids[i];
    const M inside = shares(batch.inside.word[solid.place / 64], U(1ull << (solid.place % 64)));
    M near = rays.active;
    if (!solid.is_large)
        near = near & (inside | shares(rays.contacts, U(15ull << (4 * i))) |
                       meet_sphere(program_, rays, solid.middle, solid.reach, found.nearest.t));
    if (!any(near)) {
        batch.crossing[i] = F(infinity);
        return;
    }
    const NextCrossings next = solid.way == Way::cup ? next_of_cup(program_, solid, rays)
                                                     : next_crossings(program_, solid, rays);
    const F t = select(inside, next.leave, next.enter),
            end = select(inside, next.enter, next.leave);
    found.doubt = found.doubt | (near & (next.doubt | (next.odd ^ inside) | (end < t)));
    found.third = min(found.third, select(near, end, F(infinity)));
    come_to(batch, found, solid, i, select(near, t, F(infinity)),
            select(inside, next.leave_face, next.enter_face));
}

/// Any other solid, by its stretches.
HWY_INLINE void Kernel::approach_any(Batch& batch, Findings& found, std::size_t i) {
    const Solid& solid = program_.solids[i];
    const bool is_near = ask(batch, found.nearest.t, i);
    const Stretch& one = batch.stretches[2 * i];
    if (solid.rank < 0) {
        U& word = batch.inside.word[solid.place / 64];
        const U bit(1ull << (solid.place % 64));
        M inside = one.in == F(-infinity);
        if (has_two_stretches(solid.kind))
            inside = inside | (batch.stretches[2 * i + 1].in == F(-infinity));
        word = but_not(word, bit) | only(solid.inverse ? !inside : inside, bit);
    }
    if (!is_near) {
        batch.crossing[i] = batch.crossing_end[i] = F(infinity);
        return;
    }
    const auto next_of = [](const Stretch& stretch, F& t, F& end, F& face) HWY_ATTR {
        const M leaves = stretch.in == F(-infinity);
        t = select(leaves, stretch.out, stretch.in);
        end = select(leaves, F(infinity), stretch.out);
        face = select(leaves, stretch.face_out, stretch.face_in);
    };
    F t, end, face(0.0);
    next_of(one, t, end, face);
    if (has_two_stretches(solid.kind)) {
        F other, other_end, other_face;
        next_of(batch.stretches[2 * i + 1], other, other_end, other_face);
        face = select(other < t, other_face, face);
        end = min(min(end, other_end), max(t, other));
        t = min(t, other);
    }
    if (has_two_stretches(solid.kind)) {
        found.third = min(found.third, end);
    } else {
        batch.crossing_end[i] = end;
        found.second = min(found.second, end);
    }
    if (!has_faces(solid.kind)) face = F(0.0);
    come_to(batch, found, solid, i, t, face);
}

/// Where a ray next crosses solid `i`.
HWY_INLINE void Kernel::come_to(Batch& batch, Findings& found, const Solid& solid, std::size_t i,
                                F t, F face) {
    batch.crossing[i] = t;
    found.second = min(found.second, max(found.first, t));
    found.first = min(found.first, t);
    if (has_faces(solid.kind)) batch.crossing_face[i] = face;
    const Hiding hiding = batch.around->hiding[i];
    if (hiding == Hiding::always) return;
    Crossing& nearest = found.nearest;
    M nearer = t < nearest.t;
    if (hiding == Hiding::by_list) nearer = but_not(nearer, hidden_from(batch, solid));
    nearest.t = select(nearer, t, nearest.t);
    nearest.index = select(nearer, U(i), nearest.index);
    if (program_.has_faces) nearest.face = select(nearer, face, nearest.face);
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
