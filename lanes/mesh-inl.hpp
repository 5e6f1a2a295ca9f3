// Meshes: the host says where the rays of a step come to them, of all rays at once.

#if defined(MENISCUS_LANES_MESH) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_MESH
#undef MENISCUS_LANES_MESH
#else
#define MENISCUS_LANES_MESH
#endif

#include "lanes/kernel-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

/// The rays that do not miss the box around a mesh, which has a margin.
HWY_INLINE M meet_box(const Solid& solid, const Rays& rays) {
    Line scratch;
    const Line& ray = local(solid, rays, scratch);
    const F origin[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
    const F direction[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
    F enter(0.0), leave(infinity);
    for (int axis = 0; axis < 3; ++axis) {
        const F inverse = F(1.0) / direction[axis];
        const F one = (F(solid.low[axis]) - origin[axis]) * inverse;
        const F other = (F(solid.high[axis]) - origin[axis]) * inverse;
        // Along a face of the box these may be no numbers: then no bound is drawn in.
        const M is_sure = (one <= other) | (other < one);
        enter = select(is_sure, max(enter, min(one, other)), enter);
        leave = select(is_sure, min(leave, max(one, other)), leave);
    }
    return !(leave < enter);
}

/// The strongest first: it is most likely to end a ray, and what lies behind that is not asked for.
/// So events that turn out to lie farther away are not sure.
HWY_INLINE void Kernel::approach_meshes(Batch& batch, Findings& found) {
    for (const int i : program_.meshes) approach_mesh(batch, found, std::size_t(i));
    batch.mesh_known = min(batch.mesh_known, mesh_reach(batch, nearest_sure(found)));
}

/// What lies nearer than the event, as far as that is known.
HWY_INLINE F Kernel::nearest_sure(const Findings& found) const {
    return select(found.doubt, F(infinity), found.nearest.t);
}

/// Twice the reach beyond `t` within which crossings may have a say in an event (`doubt_meshes`).
HWY_INLINE F Kernel::mesh_reach(const Batch& batch, F t) const {
    return t + (mesh_slack(batch) + F(2e-7) * t);
}
HWY_INLINE F Kernel::mesh_slack(const Batch& batch) const {
    return F(2e-7) * (batch.rays.largest + F(program_.largest_magnitude)) +
           F(200.0 * program_.contact_tolerance);
}

/// Where the rays next cross mesh `i`; its stretches serve the whole lists too, so that no mesh is
/// searched twice in a step.
HWY_INLINE void Kernel::approach_mesh(Batch& batch, Findings& found, std::size_t i) {
    const Rays& rays = batch.rays;
    const Solid& solid = program_.solids[i];
    U& word = batch.inside.word[solid.place / 64];
    const U bit(1ull << (solid.place % 64));
    M known = shares(rays.contacts, U(15ull << (4 * i)));
    if (solid.rank >= 0) known = known | (solid.inverse ? !shares(word, bit) : shares(word, bit));
    M near = rays.active & sees(batch, solid) &
             (known | meet_sphere(program_, rays, solid.middle, solid.reach, nearest_sure(found)));
    if (any(but_not(near, known))) near = near & (known | meet_box(solid, rays));
    batch.is_near[i] = any(near);
    Stretch &one = batch.stretches[2 * i], &two = batch.stretches[2 * i + 1];
    if (!batch.is_near[i]) {
        one.in = one.out = two.in = two.out = F(infinity);
        batch.crossing[i] = batch.crossing_end[i] = F(infinity);
        return;
    }
    const M hidden = solid.rank >= 0 ? hidden_from(batch, solid) : no_lanes();
    ask_mesh(batch, found, i, near, hidden);
    const M leaves = one.in == F(-infinity);
    if (solid.rank < 0) word = but_not(word, bit) | only(solid.inverse ? !leaves : leaves, bit);
    const F end = select(leaves, F(infinity), one.out);
    batch.crossing_end[i] = end;
    found.second = min(found.second, end);
    found.third = min(found.third, two.in);
    come_to(batch, found, solid, i, select(leaves, one.out, one.in),
            select(leaves, one.face_out, one.face_in));
}

/// Asks the host about the lines of `which`, no farther than their event may lie.
HWY_INLINE void Kernel::ask_mesh(Batch& batch, const Findings& found, std::size_t i, M which,
                                 M hidden) {
    const Rays& rays = batch.rays;
    const Solid& solid = program_.solids[i];
    F nearest = nearest_sure(found);
    if (batch.is_shadow) nearest = min(nearest, rays.t_max);
    const Doubles slacks(mesh_slack(batch)), farthest(mesh_reach(batch, nearest)),
        births(rays.birth);
    const Words contacts(rays.contacts), triangles(batch.mesh_contacts),
        lists(batch.inside.word[solid.place / 64]);
    const std::uint32_t are_hidden = bits(hidden);
    const Line3 lines(rays);
    std::uint64_t later = 0;  // contacts with meshes of higher index
    for (const int other : program_.meshes) {
        if (std::size_t(other) > i) later |= 15ull << (4 * other);
    }

    MeshRay asked[lanes];
    MeshMet met[lanes];
    std::size_t count = 0;
    for_each(which, [&](std::size_t lane) {
        MeshRay& ray = asked[count++];
        ray.ray = lines.ray(lane);
        ray.birth_magnitude = births[lane];
        ray.farthest = farthest[lane];
        const bool has_contact = (contacts[lane] >> (4 * i) & 15) != 0;
        const bool listed = (lists[lane] >> (solid.place % 64) & 1) != 0;
        ray.knows_side = solid.rank >= 0 || has_contact;
        ray.is_inside = listed != solid.inverse;
        const std::uint64_t pair =
            (contacts[lane] & later) != 0 ? triangles[lane] >> 32 : triangles[lane];
        ray.born_on = has_contact ? geom::Face(pair & 0xffffffffu) - 1 : geom::no_face;
        ray.is_hidden = (are_hidden >> lane & 1) != 0;
        ray.slack = slacks[lane];
        ray.slack_per_t = 2e-7;
    });
    host_.meet_mesh(solid, {asked, count}, met);

    Doubles t[most_mesh_crossings], face[most_mesh_crossings];  // in, out, in, out
    for (int k = 0; k < most_mesh_crossings; ++k) {
        t[k] = Doubles(F(infinity));
        face[k] = Doubles(F(0.0));
    }
    Doubles known{F(infinity)};
    std::uint32_t unsure = 0;
    count = 0;
    for_each(which, [&](std::size_t lane) {
        const MeshMet& answer = met[count++];
        if (!answer.is_sure) {
            unsure |= 1u << lane;
            return;
        }
        int k = 0;
        if (answer.starts_inside) t[k++][lane] = -infinity;
        known[lane] = answer.known;
        for (int n = 0; n < answer.count; ++n, ++k) {
            if (k == most_mesh_crossings) {  // one too many
                known[lane] = answer.at[std::size_t(n)].t;
                break;
            }
            t[k][lane] = answer.at[std::size_t(n)].t;
            face[k][lane] = double(answer.at[std::size_t(n)].face);
        }
    });
    batch.mesh_doubt = batch.mesh_doubt | mask_of(unsure);
    batch.mesh_known = min(batch.mesh_known, load(known.at));
    for (std::size_t half = 0; half < 2; ++half) {
        Stretch& stretch = batch.stretches[2 * i + half];
        stretch.in = load(t[2 * half].at);
        stretch.out = load(t[2 * half + 1].at);
        stretch.face_in = load(face[2 * half].at);
        stretch.face_out = load(face[2 * half + 1].at);
    }
}

/// Rays for which a mesh was too close to call, or not asked as far as their event reaches.
HWY_INLINE void Kernel::doubt_meshes(Batch& batch) const {
    const Rays& rays = batch.rays;
    const F reach = max(F(1e-7) * (rays.largest + batch.t + F(program_.largest_magnitude)),
                        F(100.0 * program_.contact_tolerance));
    batch.unsure = batch.unsure | batch.mesh_doubt | (batch.mesh_known <= batch.t + reach);
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
