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
    const Doubles px(batch.point.x), py(batch.point.y), pz(batch.point.z), nx(batch.normal.x),
        ny(batch.normal.y), nz(batch.normal.z), red(batch.throughput.x), green(batch.throughput.y),
        blue(batch.throughput.z), solids(batch.surface), owners(batch.owner), faces(batch.face),
        ranks_before(batch.before_top.rank), ranks_after(batch.after_top.rank),
        magnitudes(batch.magnitude), ways(batch.t), ox(batch.rays.world.origin.x),
        oy(batch.rays.world.origin.y), oz(batch.rays.world.origin.z),
        dx(batch.rays.world.direction.x), dy(batch.rays.world.direction.y),
        dz(batch.rays.world.direction.z), weights(batch.weight), limits(batch.rays.t_max);
    const Words codes(batch.code), levels(batch.level), keys(batch.key), contacts(batch.contacts),
        sphere_contacts(batch.sphere_contacts_after);
    Words before_words[list_words], after_words[list_words];
    for (int w = 0; w < program_.words; ++w) {
        before_words[w] = Words(batch.before.word[w]);
        after_words[w] = Words(batch.after.word[w]);
    }
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
        surface.part = surface.is_member ? program_.members[std::size_t(owners[lane])].part
                                         : program_.solids[std::size_t(solids[lane])].part;
        surface.face = int(faces[lane]);
        surface.rank_before = int(ranks_before[lane]);
        surface.rank_after = int(ranks_after[lane]);
        for (int w = 0; w < program_.words; ++w) {
            surface.before[std::size_t(w)] = before_words[w][lane];
            surface.after[std::size_t(w)] = after_words[w][lane];
        }
        surface.contacts = contacts[lane];
        if (!program_.groups.empty()) surface.sphere_contacts = sphere_contacts[lane];
        surface.magnitude = magnitudes[lane];
        surface.level = int(levels[lane] >> RayCode::level_shift);
        add_light(surface.ray.code, host_.shade(surface, stacks_));
    });
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
