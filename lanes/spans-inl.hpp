// Where rays run inside solids, in lanes. The formulas are those of the room geom, which says where
// they come from; what is too close to call is marked `unsure` and left to the general way.

#if defined(MENISCUS_LANES_SPANS) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_SPANS
#undef MENISCUS_LANES_SPANS
#else
#define MENISCUS_LANES_SPANS
#endif

#include "lanes/vector-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

inline constexpr double infinity = geom::infinity;

/// Rays as lines in some frame.
struct Line {
    F3 origin, direction;
    F squared_length;  // of the direction
};

/// The rays of one step.
struct Rays {
    Line world;
    F largest;  // max |coordinate| of the origin
    F birth;    // M where the ray was born, at least `largest`
    F t_max;    // of rays to lights
    U contacts;
    M active;

    /// Before this, list and place disagree; solids' own sizes aside.
    HWY_INLINE F sure_start(const Program& program) const {
        return F(-2.0 * program.tolerance_units * unit_roundoff) * birth;
    }
    /// Chords shorter than this may be none; sizes and distances aside. No point of a solid is
    /// farther away than 1.8 (largest + its magnitude).
    HWY_INLINE F thin() const { return F(3.0 * thin_chord) * largest; }
    /// Crossings behind the event up to here have a say in its lists.
    HWY_INLINE F margin(const Program& program) const {
        return F(1e-6) * (largest + F(program.largest_magnitude)) +
               F(1e3 * program.contact_tolerance);
    }
};

/// What a line has inside a convex shape: (t0, t1), through face0 in and face1 out.
struct Span {
    F t0, t1;
    F face0, face1;  // whole numbers, of shapes that have several
    M hit;
};

/// A stretch [in, out] of a ray inside a shape, once its list has been asked: -infinity at `in`
/// says that the ray starts inside.
struct Stretch {
    F in, out;
    F face_in, face_out;  // of shapes that have several
};

/// The rays in a solid's own frame; t stays what it is.
HWY_INLINE const Line& local(const Solid& solid, const Rays& rays, Line& scratch) {
    if (!solid.placed) return rays.world;
    const geom::Mat3& inverse = solid.transform.inverse_linear();
    scratch.origin = transform(inverse, rays.world.origin - F3(solid.transform.shift()));
    scratch.direction = transform(inverse, rays.world.direction);
    scratch.squared_length = dot(scratch.direction, scratch.direction);
    return scratch;
}

/// The face of `solid` that each ray was born on, plus 1; 0 for none.
HWY_INLINE U contact_of(const Rays& rays, int index) {
    return shift_right(rays.contacts, 4 * index) & U(15);
}

/// Half the chord of a sphere, in a frame whose directions have unit length; `e` is the way from
/// its centre to the origin, b its share along the ray.
HWY_INLINE F ball_half(const Solid& solid, const Line& ray, const F3& e, F b, M pinned) {
    const F3 f = e - b * ray.direction;
    const F discriminant = F(solid.radius * solid.radius) - dot(f, f);
    // A ray born on the sphere meets it there and at twice the middle.
    return select(pinned, abs(b), sqrt(max(discriminant, F(0.0))));
}

/// The span of a sphere in such a frame.
HWY_INLINE Span ball_span(const Solid& solid, const Line& ray, M pinned) {
    const F3 e = ray.origin - F3(solid.center);
    const F b = dot(e, ray.direction);
    const F half = ball_half(solid, ray, e, b, pinned);
    Span span;
    span.t0 = -b - half;
    span.t1 = half - b;
    span.hit = F(0.0) < half;
    return span;
}

/// The same in any frame.
HWY_INLINE Span sphere_span(const Solid& solid, const Rays& rays, M pinned) {
    if (!solid.placed) return ball_span(solid, rays.world, pinned);
    Line scratch;
    const Line& ray = local(solid, rays, scratch);
    const F3 e = ray.origin - F3(solid.center);
    const F b = dot(e, ray.direction) / ray.squared_length;
    const F3 f = e - b * ray.direction;
    const F discriminant = (F(solid.radius * solid.radius) - dot(f, f)) / ray.squared_length;
    const F half = select(pinned, abs(b), sqrt(max(discriminant, F(0.0))));
    Span span;
    span.t0 = -b - half;
    span.t1 = half - b;
    span.hit = F(0.0) < half;
    return span;
}

HWY_INLINE Span half_space_span(const Solid& solid, const Rays& rays, M pinned) {
    const F3 n(solid.center);
    const F slope = dot(rays.world.direction, n);
    const F depth = F(solid.distance) - dot(rays.world.origin, n);
    const M parallel = slope == F(0.0);
    const F t = select(pinned, F(0.0), depth / slope);
    const M leaves = F(0.0) < slope;
    Span span;
    span.t0 = select(leaves | parallel, F(-infinity), t);
    span.t1 = select(leaves, t, F(infinity));
    span.hit = !but_not(parallel, but_not(F(0.0) < depth, pinned));
    return span;
}

/// Narrows a span to [near, far].
HWY_INLINE void clip(Span& span, F near, F near_face, F far, F far_face) {
    const M later = span.t0 < near, sooner = far < span.t1;
    span.t0 = select(later, near, span.t0);
    span.face0 = select(later, near_face, span.face0);
    span.t1 = select(sooner, far, span.t1);
    span.face1 = select(sooner, far_face, span.face1);
}

HWY_INLINE Span whole_line() {
    const M none = no_lanes();
    return {F(-infinity), F(infinity), F(-1.0), F(-1.0), !none};
}

HWY_INLINE Span box_span(const Solid& solid, const Rays& rays, U contact) {
    Line scratch;
    const Line& ray = local(solid, rays, scratch);
    const F origin[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
    const F direction[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
    Span span = whole_line();
    for (int axis = 0; axis < 3; ++axis) {
        const F from_low = origin[axis] - F(solid.low[axis]);
        const F from_high = origin[axis] - F(solid.high[axis]);
        const M on_low = contact == U(std::uint64_t(2 * axis + 1));
        const M on_high = contact == U(std::uint64_t(2 * axis + 2));
        const M parallel = direction[axis] == F(0.0);
        const F inverse = F(1.0) / direction[axis];
        const F at_low = select(on_low, F(0.0), -from_low * inverse);
        const F at_high = select(on_high, F(0.0), -from_high * inverse);
        const M upwards = F(0.0) < direction[axis];
        const F low_face(2.0 * axis), high_face(2.0 * axis + 1.0);
        clip(span, select(parallel, F(-infinity), select(upwards, at_low, at_high)),
             select(upwards, low_face, high_face),
             select(parallel, F(infinity), select(upwards, at_high, at_low)),
             select(upwards, high_face, low_face));
        // Half open, so that a line within a shared face belongs to one of two stacked boxes.
        const M above = (F(0.0) <= from_low) | on_low;
        const M below = but_not(from_high < F(0.0), on_high);
        span.hit = but_not(span.hit, but_not(parallel, above & below));
    }
    span.hit = span.hit & (span.t0 < span.t1);
    return span;
}

HWY_INLINE Span cylinder_span(const Solid& solid, const Rays& rays, U contact) {
    constexpr double side_face = 0.0, base_face = 1.0, cap_face = 2.0;  // as geom::Cylinder's
    Line scratch;
    const Line& ray = local(solid, rays, scratch);
    const F3 axis(solid.axis);
    const F3 e = ray.origin - F3(solid.center);
    const F along_e = dot(e, axis), along_d = dot(ray.direction, axis);
    const F3 across_e = e - along_e * axis, across_d = ray.direction - along_d * axis;

    // The two caps.
    Span span = whole_line();
    const M on_base = contact == U(2), on_cap = contact == U(3), on_side = contact == U(1);
    const M flat = along_d == F(0.0);
    const F inverse = F(1.0) / along_d;
    const F at_base = select(on_base, F(0.0), -along_e * inverse);
    const F at_cap = select(on_cap, F(0.0), (F(solid.length) - along_e) * inverse);
    const M upwards = F(0.0) < along_d;
    clip(span, select(flat, F(-infinity), select(upwards, at_base, at_cap)),
         select(upwards, F(base_face), F(cap_face)),
         select(flat, F(infinity), select(upwards, at_cap, at_base)),
         select(upwards, F(cap_face), F(base_face)));
    const M between =
        but_not((on_base | (F(0.0) <= along_e)) & (along_e < F(solid.length)), on_cap);
    span.hit = but_not(span.hit, but_not(flat, between));

    // The side.
    const F dd = dot(across_d, across_d);
    const M parallel = dd < F(1e-30) * (along_d * along_d);
    const F per_dd = F(1.0) / dd;
    const F b = dot(across_d, across_e) * per_dd;
    const F3 f = across_e - b * across_d;
    const F discriminant = (F(solid.radius * solid.radius) - dot(f, f)) * per_dd;
    const F half = sqrt(max(discriminant, F(0.0)));
    const F twice = -(b + b);
    const F low = select(on_side, min(F(0.0), twice), -b - half);
    const F high = select(on_side, max(F(0.0), twice), half - b);
    const M exists = (on_side & (low < high)) | but_not(F(0.0) < discriminant, on_side);
    const M within = but_not(dot(across_e, across_e) < F(solid.radius * solid.radius), on_side);
    clip(span, select(parallel, F(-infinity), low), F(side_face),
         select(parallel, F(infinity), high), F(side_face));
    span.hit = span.hit & (select_mask(parallel, within, exists)) & (span.t0 < span.t1);
    return span;
}

/// The rare cases of `resolve`, by exact bounds.
inline void resolve_doubt(const Program& program, const Solid& solid, const Rays& rays,
                          const Span& span, M inside, M astray, M& enters, M& unsure) {
    const F start = max(span.t0, F(0.0));
    const F chord = span.t1 - start;
    const F at = rays.largest + F(solid.magnitude) + start;
    const F least(program.contact_tolerance);
    const M thin = enters & (chord < max(F(thin_chord) * at, least + least));
    const M touch = chord <= max(F(program.tolerance_units * unit_roundoff) * at, least);
    const M early = select(inside, span.t1, span.t0) < -(least + least);
    unsure = unsure | (astray & early) | but_not(thin, touch);
    enters = but_not(enters, thin & touch);
}

/// What a convex shape's span means to a ray whose list is known (tracer/offers.cpp, of which this
/// is the sure part): a ray inside can only leave, one outside only enter; chords thinner than the
/// tolerance are none.
HWY_INLINE Stretch resolve(const Program& program, const Solid& solid, const Rays& rays,
                           const Span& span, M inside, M has_contact, M& unsure) {
    M enters = but_not(span.hit & (F(0.0) < span.t1), inside);
    const F start = max(span.t0, F(0.0));
    // Seldom: a chord about as thin as the tolerance, or a start at which list and place disagree
    // by more than rounding.
    const M thin = enters & (span.t1 - start < rays.thin() + F(solid.thin));
    const F sure_start = rays.sure_start(program) - F(solid.sure_start);
    const M astray =
        but_not((inside & (span.t1 < sure_start)) | (enters & (span.t0 < sure_start)), has_contact);
    if (any(thin | astray))
        resolve_doubt(program, solid, rays, span, inside, astray, enters, unsure);

    Stretch result;
    result.in = select(inside, F(-infinity), select(enters, start, F(infinity)));
    result.out = select(inside | enters, max(span.t1, F(0.0)), F(infinity));
    return result;
}

/// How rays pass by a point.
struct Passing {
    F along;   // where they are, from the place where they are nearest to it
    F3 foot;   // from the point to that place
    F square;  // of its length

    HWY_INLINE Passing(const Rays& rays, const geom::Vec3& point) {
        const F3 e = rays.world.origin - F3(point);
        along = dot(e, rays.world.direction);
        foot = e - along * rays.world.direction;
        square = dot(foot, foot);
    }
    /// The lanes that meet a sphere around it before what is nearest so far, or not far behind.
    HWY_INLINE M meet(const Program& program, const Rays& rays, double radius, F nearest) const {
        const F room = F(radius * radius) - square;
        // The ray comes in at -along - sqrt(room).
        const F beyond = along + (nearest * F(1.0 + 1e-6) + rays.margin(program));
        return (F(0.0) < room) & ((along < F(0.0)) | (along * along < room)) &
               ((F(0.0) < beyond) | (beyond * beyond < room));
    }
};

HWY_INLINE M meet_sphere(const Program& program, const Rays& rays, const geom::Vec3& center,
                         double radius, F nearest) {
    return Passing(rays, center).meet(program, rays, radius, nearest);
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
