// Third stage of a step: where on a surface the rays are, and its normal there.

#if defined(MENISCUS_LANES_PUT_ON_FACES) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_PUT_ON_FACES
#undef MENISCUS_LANES_PUT_ON_FACES
#else
#define MENISCUS_LANES_PUT_ON_FACES
#endif

#include "lanes/kernel-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

/// Puts the points of an event on the faces that own it.
HWY_INLINE void Kernel::put_on_faces(Batch& batch) {
    const Rays& rays = batch.rays;
    const M by_member = but_not(batch.met, batch.same | batch.by_surface);
    batch.point = rays.world.origin + batch.t * rays.world.direction;
    batch.normal = F3(geom::Vec3{0.0, 1.0, 0.0});
    F owner_magnitude(program_.one_tolerance ? program_.largest_magnitude : 0.0);
    for (std::size_t i = 0; i < program_.solids.size(); ++i) {
        const Solid& solid = program_.solids[i];
        if (is_plain_ball(solid) || (!batch.is_near[i] && !solid.inverse)) continue;
        const M here = solid.rank < 0 ? batch.by_surface & (batch.surface == F(double(i)))
                                      : by_member & (batch.owner == F(double(solid.rank)));
        if (!any(here)) continue;
        const FacePoint put = is_foreign(solid.kind)
                                  ? ask_face(solid, here, batch.point, batch.face)
                                  : face_point(solid, batch.point, batch.face);
        batch.point = select(here, put.point, batch.point);
        batch.normal =
            select(here, solid.inverse ? F(-1.0) * put.normal : put.normal, batch.normal);
        owner_magnitude = select(here, F(solid.magnitude), owner_magnitude);
    }
    put_on_balls(batch, by_member, owner_magnitude);
    batch.magnitude = rays.largest + batch.t + owner_magnitude;
}

/// Spheres are alike: all lanes that are on one, at once.
HWY_INLINE void Kernel::put_on_balls(Batch& batch, M by_member, F& owner_magnitude) const {
    const U index = batch.owner_index;
    Round round;
    round.which = by_member & (F(0.0) < look_up(table_.radius, index));
    if (batch.near_spheres == 0 && !any(round.which)) return;
    round.center = {look_up(table_.x, index), look_up(table_.y, index), look_up(table_.z, index)};
    round.radius = look_up(table_.radius, index);
    round.inverse_radius = look_up(table_.inverse_radius, index);
    if (!program_.one_tolerance)
        owner_magnitude = select(round.which, look_up(table_.magnitude, index), owner_magnitude);
    if (batch.near_spheres != 0) add_small_spheres(batch, by_member, round, owner_magnitude);
    const F3 e = batch.point - round.center;
    // The point is on the sphere but for rounding: a step of Newton's method for 1 / length.
    const F share = dot(e, e) * (round.inverse_radius * round.inverse_radius);
    const F3 n = (round.inverse_radius * (F(1.5) - F(0.5) * share)) * e;
    batch.normal = select(round.which, n, batch.normal);
    batch.point = select(round.which, round.center + round.radius * n, batch.point);
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
