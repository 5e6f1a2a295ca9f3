// Surfaces that the host shades, one ray at a time.

#if defined(MENISCUS_LANES_DRESS) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_DRESS
#undef MENISCUS_LANES_DRESS
#else
#define MENISCUS_LANES_DRESS
#endif

#include "lanes/kernel-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

HWY_INLINE void Kernel::dress(const Batch& batch) {
    const F3 throughput = throughput_of(batch);
    const Doubles px(batch.point.x), py(batch.point.y), pz(batch.point.z), nx(batch.normal.x),
        ny(batch.normal.y), nz(batch.normal.z), red(throughput.x), green(throughput.y),
        blue(throughput.z), faces(batch.face), magnitudes(batch.magnitude), ways(batch.t),
        ox(batch.rays.world.origin.x), oy(batch.rays.world.origin.y), oz(batch.rays.world.origin.z),
        dx(batch.rays.world.direction.x), dy(batch.rays.world.direction.y),
        dz(batch.rays.world.direction.z), weights(batch.is_shadow ? F(1.0) : batch.weight),
        limits(batch.is_shadow ? batch.rays.t_max : F(infinity));
    const Words codes(batch.code), levels(batch.level),
        keys(has_key(batch.is_shadow) ? batch.key : U(0)), contacts(batch.contacts),
        sphere_contacts(program_.groups.empty() ? U(0) : batch.sphere_contacts_after),
        mesh_contacts(program_.has_meshes ? batch.mesh_contacts_after : U(0));
    const Words owners(batch.owner_index);
    const ListWords before(batch.before, program_), after(batch.after, program_);
    const std::uint32_t surfaces = bits(batch.by_surface);
    for_each(batch.dressed, [&](std::size_t lane) {
        Surface surface;
        surface.ray.origin = {ox[lane], oy[lane], oz[lane]};
        surface.ray.direction = {dx[lane], dy[lane], dz[lane]};
        surface.ray.throughput = {red[lane], green[lane], blue[lane]};
        surface.ray.weight = weights[lane];
        surface.ray.t_max = limits[lane];
        surface.ray.code = codes[lane];
        surface.ray.key = keys[lane];
        surface.t = ways[lane];
        surface.point = {px[lane], py[lane], pz[lane]};
        surface.normal = {nx[lane], ny[lane], nz[lane]};
        surface.is_member = !(surfaces >> lane & 1u);
        surface.part = owners[lane] == is_small_sphere
                           ? program_.members[std::size_t(batch.sphere_ranks[lane])].part
                           : program_.solids[owners[lane]].part;
        surface.face = int(faces[lane]);
        surface.rank_before = before.top(lane);
        surface.rank_after = after.top(lane);
        for (int w = 0; w < program_.words; ++w) {
            surface.before[std::size_t(w)] = before.word[w][lane];
            surface.after[std::size_t(w)] = after.word[w][lane];
        }
        surface.contacts = contacts[lane];
        if (!program_.groups.empty()) surface.sphere_contacts = sphere_contacts[lane];
        if (program_.has_meshes) surface.mesh_contacts = mesh_contacts[lane];
        surface.magnitude = magnitudes[lane];
        surface.level = int(levels[lane] >> RayCode::level_shift);
        add_light(surface.ray.code, host_.shade(surface, stacks_));
    });
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
