// Solids that the host meets, one ray at a time.

#if defined(MENISCUS_LANES_FOREIGN) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_FOREIGN
#undef MENISCUS_LANES_FOREIGN
#else
#define MENISCUS_LANES_FOREIGN
#endif

#include "lanes/kernel-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

/// What the host's own convex solids leave of the lines of `which`.
HWY_INLINE Span Kernel::ask_span(const Batch& batch, const Solid& solid, U contact, M which) {
    Doubles t0{F(infinity)}, t1{F(-infinity)}, face0{F(-1.0)}, face1{F(-1.0)};
    std::uint32_t hit = 0;
    if (any(which)) {
        const Words contacts(contact);
        const Line3 lines(batch.rays);
        for_each(which, [&](std::size_t lane) {
            const geom::Interval interval =
                host_.interval(solid, lines.ray(lane), geom::Face(contacts[lane]) - 1);
            t0[lane] = interval.t0;
            t1[lane] = interval.t1;
            face0[lane] = double(interval.face0);
            face1[lane] = double(interval.face1);
            if (interval.hit) hit |= 1u << lane;
        });
    }
    return {load(t0.at), load(t1.at), load(face0.at), load(face1.at), mask_of(hit)};
}

/// The crossings of the lines of `which` with one of the host's own solids.
HWY_INLINE LatheCrossings Kernel::ask_crossings(const Batch& batch, const Solid& solid, M which,
                                                M& unsure) {
    Doubles t[most_lathe_crossings], face[most_lathe_crossings], slope[most_lathe_crossings];
    for (int k = 0; k < most_lathe_crossings; ++k) {
        t[k] = Doubles(F(infinity));
        face[k] = slope[k] = Doubles(F(0.0));
    }
    std::uint32_t too_many = 0;
    if (any(which)) {
        const Line3 lines(batch.rays);
        for_each(which, [&](std::size_t lane) {
            Met met[most_lathe_crossings];
            const int count = host_.crossings(solid, lines.ray(lane), met);
            if (count < 0) too_many |= 1u << lane;
            for (int k = 0; k < count; ++k) {
                t[k][lane] = met[k].t;
                face[k][lane] = double(met[k].face);
                slope[k][lane] = met[k].slope;
            }
        });
    }
    unsure = unsure | mask_of(too_many);
    LatheCrossings found;
    for (int k = 0; k < most_lathe_crossings; ++k) {
        found.t[k] = load(t[k].at);
        found.piece[k] = load(face[k].at);
        found.slope[k] = load(slope[k].at);
    }
    return found;
}

/// Points on a face of one of the host's own solids.
HWY_INLINE FacePoint Kernel::ask_face(const Solid& solid, M which, const F3& point, F face) {
    Doubles x{point.x}, y{point.y}, z{point.z}, nx{F(0.0)}, ny{F(1.0)}, nz{F(0.0)};
    const Doubles faces(face);
    for_each(which, [&](std::size_t lane) {
        geom::Vec3 p{x[lane], y[lane], z[lane]};
        const geom::Vec3 n = host_.put_on_face(solid, geom::Face(faces[lane]), p);
        x[lane] = p.x;
        y[lane] = p.y;
        z[lane] = p.z;
        nx[lane] = n.x;
        ny[lane] = n.y;
        nz[lane] = n.z;
    });
    return {{load(x.at), load(y.at), load(z.at)}, {load(nx.at), load(ny.at), load(nz.at)}};
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
