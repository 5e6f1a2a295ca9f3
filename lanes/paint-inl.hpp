// Surfaces that nothing shines through, of a plain colour or chequered, under point lights.

#if defined(MENISCUS_LANES_PAINT) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_PAINT
#undef MENISCUS_LANES_PAINT
#else
#define MENISCUS_LANES_PAINT
#endif

#include "lanes/kernel-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

/// The colour of a paint at each point.
HWY_INLINE F3 colour_at(const Paint& paint, const F3& world) {
    if (!paint.is_checker) return F3(paint.colours[0]);
    // Parity of the unit cell; the small shift as in tracer/pigment.cpp.
    const F3 p = transform(paint.to_cells, world) + F3(paint.shift + 1e-10);
    const F cell = floor(p.x) + floor(p.y) + floor(p.z);
    const M is_odd = !(cell - F(2.0) * floor(F(0.5) * cell) == F(0.0));
    return select(is_odd, F3(paint.colours[1]), F3(paint.colours[0]));
}

/// Their own light goes to the pixel, rays to the lights on the stack. (POV-Ray's rules, as in
/// tracer/shading.cpp.)
HWY_INLINE void Kernel::paint(const Batch& batch) {
    if (batch.is_shadow) return add_light(batch.painted, batch.code, F3(geom::Vec3{0.0}));
    const F3& eye_ray = batch.rays.world.direction;
    const F3 throughput = throughput_of(batch);
    const F3 normal =
        select(F(0.0) < dot(batch.normal, eye_ray), F(-1.0) * batch.normal, batch.normal);
    for (std::size_t i = 0; i < program_.solids.size(); ++i) {
        const Solid& solid = program_.solids[i];
        if (solid.paint < 0) continue;
        const M here = batch.painted & (batch.owner_index == U(i));
        if (!any(here)) continue;
        const Paint& paint = program_.paints[std::size_t(solid.paint)];
        const F3 colour = colour_at(paint, batch.point);
        const auto times = [](const F3& u, const F3& v) HWY_ATTR {
            return F3{u.x * v.x, u.y * v.y, u.z * v.z};
        };
        PixelLight sum;
        sum.add(here, times(throughput, times(colour, F3(paint.glow))), program_.units);
        for (const Light& light : program_.lights) {
            const F3 way = F3(light.position) - batch.point;
            const F distance = sqrt(dot(way, way));
            Child child;
            child.direction = (F(1.0) / distance) * way;
            const F cosine = dot(normal, child.direction);
            const F3 thrown_back = (F(paint.diffuse) * cosine) * times(colour, F3(light.colour));
            child.light = times(throughput, thrown_back);
            child.t_max = distance;
            child.way = F(0.0);
            child.code = (batch.code & U(~(RayCode::level_mask | RayCode::straight))) |
                         batch.level | U(RayCode::shadow);
            const M lit = here & (F(1e-10) <= cosine) &
                          (F(0.0) < thrown_back.x + thrown_back.y + thrown_back.z);
            if (paint.is_open) {
                sum.add(lit, child.light, program_.units);
                continue;
            }
            counts_.shadows += count(lit);
            push(stacks_.shadows, batch, lit, child, batch.before, true);
        }
        add_light(here, batch.code, sum);
    }
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
