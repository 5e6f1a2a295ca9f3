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
    const M here = but_not(batch.met, batch.same);
    const U index = batch.owner_index;
    FacePoint all{rays.world.origin + batch.t * rays.world.direction,
                  F3(geom::Vec3{0.0, 1.0, 0.0})};
    F owner_magnitude(program_.largest_magnitude);
    if (!program_.one_tolerance) owner_magnitude = look_up(table_.magnitude, index);
    for (const int i : batch.around->floors) {
        const M on = here & (index == U(std::uint64_t(i)));
        if (!any(on)) continue;
        const Solid& solid = program_.solids[std::size_t(i)];
        const F3 n(solid.center);
        const F depth = F(solid.distance) - dot(all.point, n);
        all.point = select(on, all.point + depth * n, all.point);
        all.normal = select(on, n, all.normal);
    }
    for (const int i : batch.around->cornered) {
        const M on = here & (index == U(std::uint64_t(i)));
        if (!any(on)) continue;
        const Solid& solid = program_.solids[std::size_t(i)];
        const FacePoint put = is_foreign(solid.kind) ? ask_face(solid, on, all.point, batch.face)
                                                     : face_point(solid, all.point, batch.face);
        all.point = select(on, put.point, all.point);
        all.normal = select(on, solid.inverse ? F(-1.0) * put.normal : put.normal, all.normal);
    }
    if (batch.around->lathes) put_on_lathes(batch, here, all);
    put_on_balls(batch, here, all, owner_magnitude);
    batch.point = all.point;
    batch.normal = all.normal;
    batch.magnitude = rays.largest + batch.t + owner_magnitude;
}

/// Lathes in the world's frame differ by the pieces of their profiles: all lanes that are on one,
/// at once.
HWY_INLINE void Kernel::put_on_lathes(const Batch& batch, M here, FacePoint& all) const {
    const U face = as_words(batch.face + F(0x1p52)) & U(15);
    M which = no_lanes();
    F a(0.0), b(1.0), c(0.0);
    for (std::size_t k = 0; k < profiles_.size(); ++k) {
        const M on = here & (batch.owner_index == U(std::uint64_t(program_.lathes[k])));
        const Profile& profile = profiles_[k];
        which = which | on;
        a = select(on, look_up(profile.a, face), a);
        b = select(on, look_up(profile.b, face), b);
        c = select(on, look_up(profile.c, face), c);
    }
    if (!any(which)) return;
    const Turned turned(all.point, a, b, c);
    all.normal = select(which, turned.normal, all.normal);
    all.point = select(which, all.point + turned.way, all.point);
}

/// Spheres are alike: all lanes that are on one, at once.
HWY_INLINE void Kernel::put_on_balls(const Batch& batch, M here, FacePoint& all,
                                     F& owner_magnitude) const {
    const U index = batch.owner_index;
    Round round;
    round.which = here & (F(0.0) < look_up(table_.radius, index));
    if (batch.near_spheres == 0 && !any(round.which)) return;
    round.center = {look_up(table_.x, index), look_up(table_.y, index), look_up(table_.z, index)};
    round.radius = look_up(table_.radius, index);
    round.inverse_radius = look_up(table_.inverse_radius, index);
    if (batch.near_spheres != 0) add_small_spheres(batch, here, round, owner_magnitude);
    const F3 e = all.point - round.center;
    // The point is on the sphere but for rounding: a step of Newton's method for 1 / length.
    const F share = dot(e, e) * (round.inverse_radius * round.inverse_radius);
    const F3 n = (round.inverse_radius * (F(1.5) - F(0.5) * share)) * e;
    all.normal = select(round.which, n, all.normal);
    all.point = select(round.which, round.center + round.radius * n, all.point);
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
