// Light that arrives, and what the way leaves of it.

#if defined(MENISCUS_LANES_ARRIVE) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_ARRIVE
#undef MENISCUS_LANES_ARRIVE
#else
#define MENISCUS_LANES_ARRIVE
#endif

#include "lanes/kernel-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

/// The medium on the way, up to the event or to the light.
HWY_INLINE void Kernel::attenuate(Batch& batch) {
    M which = batch.glass | batch.dressed | batch.painted;
    if (batch.is_shadow) which = which | but_not(batch.rays.active, batch.met);
    which = which & batch.medium_before.attenuates;
    if (!any(which)) return;
    Doubles red(batch.throughput.x), green(batch.throughput.y), blue(batch.throughput.z);
    const Doubles way(batch.way_before + batch.t);
    const ListWords around(batch.before, program_);
    for_each(which, [&](std::size_t lane) {
        const geom::Vec3 share = host_.transmittance(around.top(lane), way[lane], batch.is_shadow);
        red[lane] *= share.x;
        green[lane] *= share.y;
        blue[lane] *= share.z;
    });
    batch.throughput = {load(red.at), load(green.at), load(blue.at)};
}

/// Adds light to the rays' pixels.
HWY_INLINE void Kernel::add_light(M which, U code, const F3& light) {
    PixelLight sum;
    sum.add(which, light, program_.units);
    add_light(which, code, sum);
}
HWY_INLINE void Kernel::add_light(M which, U code, const PixelLight& light) {
    const Words red(light.red), green(light.green), blue(light.blue), added(light.count),
        codes(code);
    for_each(which, [&](std::size_t lane) {
        std::int64_t* sum = sums_ + 4 * (codes[lane] & RayCode::pixel_mask);
        sum[0] += std::int64_t(red[lane]);
        sum[1] += std::int64_t(green[lane]);
        sum[2] += std::int64_t(blue[lane]);
        sum[3] += std::int64_t(added[lane]);
    });
}

/// Whether a list has a member.
HWY_INLINE M Kernel::is_in_some(const List& list) const {
    M some = no_lanes();
    for (int w = 0; w < program_.words; ++w)
        some = some | shares(list.word[w], U(program_.member_bits[std::size_t(w)]));
    return some;
}

/// Light of the sky, and of lamps that nothing hides.
HWY_INLINE void Kernel::arrive(const Batch& batch, M gone) {
    const F3 light = throughput_of(batch);
    if (batch.is_shadow) return add_light(gone, batch.code, light);
    const M plain = program_.constant_sky ? but_not(gone, is_in_some(batch.before)) : no_lanes();
    const F3 sky(program_.sky);
    add_light(plain, batch.code, {light.x * sky.x, light.y * sky.y, light.z * sky.z});
    const M other = but_not(gone, plain);
    if (!any(other)) return;
    const Doubles dx(batch.rays.world.direction.x), dy(batch.rays.world.direction.y),
        dz(batch.rays.world.direction.z), r(light.x), g(light.y), b(light.z);
    const Words codes(batch.code);
    const ListWords before(batch.before, program_);
    for_each(other, [&](std::size_t lane) {
        const geom::Vec3 seen = host_.sky({dx[lane], dy[lane], dz[lane]}, before.top(lane));
        add_light(codes[lane], {r[lane] * seen.x, g[lane] * seen.y, b[lane] * seen.z});
    });
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
