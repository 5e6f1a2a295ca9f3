// Points and normals on the faces of solids, in lanes.

#if defined(MENISCUS_LANES_FACES) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_FACES
#undef MENISCUS_LANES_FACES
#else
#define MENISCUS_LANES_FACES
#endif

#include "lanes/vector-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

/// A vector that is unit length to rounding but for the few roundings since it was made.
HWY_INLINE F3 unit(F3 v) { return (F(1.5) - F(0.5) * dot(v, v)) * v; }

/// A point put on a face, and the shape's outward unit normal there.
struct FacePoint {
    F3 point, normal;
};

/// The pieces of a lathe's profile, for `look_up`.
struct Profile {
    using Column = double[16];
    alignas(64) Column a{}, b{}, c{};

    explicit Profile(const Solid& solid) {
        for (std::size_t i = 0; i < solid.pieces.size(); ++i) {
            a[i] = solid.pieces[i].a;
            b[i] = solid.pieces[i].b;
            c[i] = solid.pieces[i].c;
        }
    }
};

/// What a piece of a lathe's profile makes of a point near it, in the lathe's frame.
struct Turned {
    F3 normal, way;  // the way from the point to the face

    HWY_INLINE Turned(const F3& p, F a, F b, F c) {
        const F radius = sqrt(p.x * p.x + p.z * p.z);
        const F inverse = F(1.0) / radius;
        const F out = select(a == F(0.0), F(0.0), a * inverse);
        normal = {out * p.x, b, out * p.z};
        way = (c - a * radius - b * p.y) * normal;
    }
};

HWY_INLINE FacePoint face_point(const Solid& solid, F3 world, F face) {
    F3 p = world;
    if (solid.placed)
        p = transform(solid.transform.inverse_linear(), world - F3(solid.transform.shift()));
    F3 n, way;  // the way from the point to the face
    switch (solid.kind) {
        case Kind::sphere: {
            const F3 e = p - F3(solid.center);
            const F length = sqrt(dot(e, e));
            n = (F(1.0) / length) * e;
            way = (F(solid.radius) - length) * n;
            break;
        }
        case Kind::half_space:
            n = F3(solid.center);
            way = (F(solid.distance) - dot(p, n)) * n;
            break;
        case Kind::box: {
            const F coordinate[3] = {p.x, p.y, p.z};
            F component[3], back[3];
            for (int axis = 0; axis < 3; ++axis) {
                const M low = face == F(2.0 * axis), high = face == F(2.0 * axis + 1.0);
                component[axis] = select(high, F(1.0), only(low, F(-1.0)));
                back[axis] =
                    only(low | high,
                         select(high, F(solid.high[axis]), F(solid.low[axis])) - coordinate[axis]);
            }
            n = {component[0], component[1], component[2]};
            way = {back[0], back[1], back[2]};
            break;
        }
        case Kind::cylinder: {
            const F3 axis(solid.axis);
            const F3 e = p - F3(solid.center);
            const F along = dot(e, axis);
            const F3 across = e - along * axis;
            const F distance = sqrt(dot(across, across));
            const M base = face == F(1.0), cap = face == F(2.0);
            const F3 side = (F(1.0) / distance) * across;
            const F sign = select(cap, F(1.0), F(-1.0));
            n = select(base | cap, sign * axis, side);
            way = select(base | cap, (only(cap, F(solid.length)) - along) * axis,
                         (F(solid.radius) - distance) * side);
            break;
        }
        case Kind::lathe: {
            F a(0.0), b(1.0), c(0.0);
            for (std::size_t i = 0; i < solid.pieces.size(); ++i) {
                const M here = face == F(double(i));
                a = select(here, F(solid.pieces[i].a), a);
                b = select(here, F(solid.pieces[i].b), b);
                c = select(here, F(solid.pieces[i].c), c);
            }
            const Turned turned(p, a, b, c);
            n = turned.normal;
            way = turned.way;
            break;
        }
        case Kind::other_convex:
        case Kind::mesh:
        case Kind::other:
            break;  // the host's
    }
    if (!solid.placed) return {world + way, n};
    // Normals go by the inverse transpose.
    const geom::Mat3& inverse = solid.transform.inverse_linear();
    const F3 turned{dot(n, F3(inverse[0])), dot(n, F3(inverse[1])), dot(n, F3(inverse[2]))};
    return {world + transform(solid.transform.linear(), way),
            (F(1.0) / sqrt(dot(turned, turned))) * turned};
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
