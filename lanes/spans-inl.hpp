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
inline constexpr double unit_roundoff = 0x1p-53;

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
    F t_max;
    U contacts;
    M active;
};

/// What a line has inside a convex shape: (t0, t1), through face0 in and face1 out.
struct Span {
    F t0, t1;
    F face0, face1;  // whole numbers
    M hit;
};

/// A stretch [in, out] of a ray inside a shape, once its list has been asked: -infinity at `in`
/// says that the ray starts inside.
struct Stretch {
    F in, out;
    F face_in, face_out;
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

HWY_INLINE Span sphere_span(const Solid& solid, const Rays& rays, U contact) {
    Line scratch;
    const Line& ray = local(solid, rays, scratch);
    const F3 e = ray.origin - F3(solid.center);
    F b = dot(e, ray.direction);
    if (solid.placed) b = b / ray.squared_length;
    const F3 f = e - b * ray.direction;
    F discriminant = F(solid.radius * solid.radius) - dot(f, f);
    if (solid.placed) discriminant = discriminant / ray.squared_length;
    const M exist = F(0.0) < discriminant;
    const F half = sqrt(max(discriminant, F(0.0)));
    const M pinned = !(contact == U(0));
    const F middle = -b;
    Span span;
    span.t0 = select(pinned, min(F(0.0), middle + middle), middle - half);
    span.t1 = select(pinned, max(F(0.0), middle + middle), middle + half);
    span.face0 = span.face1 = F(0.0);
    span.hit = (pinned & (span.t0 < span.t1)) | but_not(exist, pinned);
    return span;
}

HWY_INLINE Span half_space_span(const Solid& solid, const Rays& rays, U contact) {
    const F3 n(solid.center);
    const F slope = dot(rays.world.direction, n);
    const F depth = F(solid.distance) - dot(rays.world.origin, n);
    const M pinned = !(contact == U(0));
    const M parallel = slope == F(0.0);
    const F t = select(pinned, F(0.0), depth / slope);
    const M leaves = F(0.0) < slope;
    Span span;
    span.t0 = select(leaves | parallel, F(-infinity), t);
    span.t1 = select(leaves, t, F(infinity));
    span.face0 = span.face1 = F(0.0);
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

/// What a convex shape's span means to a ray whose list is known (tracer/offers.cpp, of which this
/// is the sure part): a ray inside can only leave, one outside only enter; chords thinner than the
/// tolerance are none.
HWY_INLINE Stretch resolve(const Program& program, const Solid& solid, const Rays& rays,
                           const Span& span, M inside, M has_contact, M& unsure) {
    const F size(solid.magnitude);
    const F hit_end = select(inside, span.t1, span.t0);
    M enters = but_not(span.hit & (F(0.0) < span.t1), inside);
    const F start = max(span.t0, F(0.0));
    // A chord near the tolerance or below it: seldom.
    const F chord = span.t1 - start;
    const F at = rays.largest + size + start;
    const M thin = enters & (chord < max(F(1e-6) * at, F(2.0 * program.contact_tolerance)));
    if (any(thin)) {
        const F tolerance =
            max(F(program.tolerance_units * unit_roundoff) * at, F(program.contact_tolerance));
        const M touch = chord <= tolerance;
        unsure = unsure | but_not(thin, touch);
        enters = but_not(enters, thin & touch);
    }
    // So is a start at which list and place disagree by more than rounding.
    const F sure_start =
        F(-2.0) * max(F(program.tolerance_units * unit_roundoff) * (rays.birth + size),
                      F(program.contact_tolerance));
    unsure = unsure | but_not((inside | enters) & (hit_end < sure_start), has_contact);

    Stretch result;
    result.in = select(inside, F(-infinity), select(enters, start, F(infinity)));
    result.out = select(inside, max(span.t1, F(0.0)), select(enters, span.t1, F(infinity)));
    result.face_in = span.face0;
    result.face_out = span.face1;
    return result;
}

/// Crossings of a line with a lathe, sorted by t.
struct LatheCrossings {
    F t[most_lathe_crossings], piece[most_lathe_crossings],
        slope[most_lathe_crossings];  // direction . normal

    HWY_INLINE void insert(F at, F of, F sloping, M valid, M& unsure) {
        at = select(valid, at, F(infinity));
        for (int k = 0; k < most_lathe_crossings; ++k) {
            const M sooner = at < t[k];
            const F later_t = select(sooner, t[k], at);
            const F later_piece = select(sooner, piece[k], of);
            const F later_slope = select(sooner, slope[k], sloping);
            t[k] = select(sooner, at, t[k]);
            piece[k] = select(sooner, of, piece[k]);
            slope[k] = select(sooner, sloping, slope[k]);
            at = later_t;
            of = later_piece;
            sloping = later_slope;
        }
        unsure = unsure | (at < F(infinity));
    }
};

/// What sorted crossings with a solid that is not convex mean to rays whose list is known. `known`
/// are the rays of which `inside` tells where they start.
HWY_INLINE void settle(const Program& program, const Solid& solid, const Rays& rays, M known,
                       M inside, const LatheCrossings& found, Stretch& first, Stretch& second,
                       M& unsure) {
    // Entering and leaving must take turns, from outside to outside.
    M open = no_lanes();
    M real[most_lathe_crossings];
    for (int k = 0; k < most_lathe_crossings; ++k) {
        real[k] = found.t[k] < F(infinity);
        const M entering = found.slope[k] < F(0.0);
        open = open | (real[k] & (k % 2 == 0 ? !entering : entering));
    }
    open = open | (real[0] ^ real[1]) | (real[2] ^ real[3]);

    // At the start the list says where the ray is (tracer/offers.cpp, collect_general).
    const F tolerance =
        max(F(program.tolerance_units * unit_roundoff) * (rays.birth + F(solid.magnitude)),
            F(program.contact_tolerance));
    M ahead[most_lathe_crossings], at_start[most_lathe_crossings];
    M inside_beyond = no_lanes();
    for (int k = 0; k < most_lathe_crossings; ++k) {
        const F t = found.t[k];
        at_start[k] = real[k] & (abs(t) * abs(found.slope[k]) <= tolerance);
        ahead[k] = but_not(real[k] & (F(0.0) < t), at_start[k]);
        inside_beyond = inside_beyond ^ ahead[k];
    }
    const M disagree = known & (inside_beyond ^ inside);
    M settled = no_lanes();
    Stretch* const results[2] = {&first, &second};
    for (int pair = 0; pair < 2; ++pair) {
        const int enter = 2 * pair, leave = enter + 1;
        Stretch& result = *results[pair];
        const M starts_by_entering =
            but_not(disagree & inside_beyond & ahead[leave] & at_start[enter], ahead[enter]);
        const M starts_by_leaving = but_not(disagree & at_start[leave], inside_beyond);
        settled = settled ^ (starts_by_entering | starts_by_leaving);
        const F none(infinity);
        result.in = select(
            ahead[leave],
            select(ahead[enter], found.t[enter], select(starts_by_entering, F(0.0), F(-infinity))),
            select(starts_by_leaving, F(-infinity), none));
        result.out = select(ahead[leave], found.t[leave], select(starts_by_leaving, F(0.0), none));
        result.face_in = found.piece[enter];
        result.face_out = found.piece[leave];
    }
    unsure = unsure | open | but_not(disagree, settled);
}

/// A lathe of straight pieces about its y axis; two stretches. `known` are the rays of which
/// `inside` tells where they start.
HWY_INLINE void lathe_stretches(const Program& program, const Solid& solid, const Rays& rays,
                                M known, M inside, Stretch& first, Stretch& second, M& unsure) {
    Line scratch;
    const Line& ray = local(solid, rays, scratch);
    F3 d = ray.direction;
    F length(1.0);
    if (solid.placed) {
        length = sqrt(ray.squared_length);
        d = (F(1.0) / length) * d;
    }
    // Seen from the line's point nearest to the middle.
    const F3 from_middle = ray.origin - F3(geom::Vec3{0.0, solid.middle, 0.0});
    const F shift = -dot(from_middle, d);
    const F3 e = from_middle + shift * d;
    const F height = e.y + F(solid.middle);
    const F dd = d.x * d.x + d.z * d.z, ed = e.x * d.x + e.z * d.z, ee = e.x * e.x + e.z * e.z;
    const M steep = dd < F(1e-12);  // along the axis
    const F per_dd = F(1.0) / dd;
    const F b = ed * per_dd;
    const F fx = e.x - b * d.x, fz = e.z - b * d.z;
    const F ff = fx * fx + fz * fz;
    const F per_dy = F(1.0) / d.y;
    const F slack(1e-9 * solid.size);

    LatheCrossings found;
    for (int k = 0; k < most_lathe_crossings; ++k) {
        found.t[k] = F(infinity);
        found.piece[k] = found.slope[k] = F(0.0);
    }
    M open = no_lanes();  // lanes for which these crossings are not sure
    const F narrow_miss(solid.size * solid.size * 1e-9);
    for (std::size_t i = 0; i < solid.pieces.size(); ++i) {
        const Piece& piece = solid.pieces[i];
        const F index{double(i)};
        if (piece.a == 0.0) {  // a ring
            const F t = (F(piece.low_height) - height) * per_dy;
            const F x = e.x + t * d.x, z = e.z + t * d.z;
            const F radius2 = x * x + z * z;
            const F low2(piece.low_radius * piece.low_radius),
                high2(piece.high_radius * piece.high_radius);
            const M within = radius2 < high2;
            const M valid = piece.low_radius > 0.0 ? but_not(within, radius2 < low2) : within;
            const F margin(2.0 * piece.high_radius * 1e-9 * solid.size);
            open = open | (abs(radius2 - high2) < margin);
            if (piece.low_radius > 0.0) open = open | (abs(radius2 - low2) < margin);
            found.insert(t, index, F(piece.b) * d.y, valid, open);
        } else if (piece.b == 0.0) {  // a cylinder
            const double radius = piece.high_radius;
            const F room = F(radius * radius) - ff;
            open = open | (abs(room) < narrow_miss);
            if (!any(F(0.0) < room)) continue;
            const F half = sqrt(max(room * per_dd, F(0.0)));
            const F slope = half * dd * F(1.0 / radius) * F(piece.a);
            for (const double side : {-1.0, 1.0}) {
                const F t = F(side) * half - b;
                const F y = height + t * d.y;
                const M valid =
                    (F(0.0) < room) & (F(piece.low_height) <= y) & (y < F(piece.high_height));
                open = open | ((F(0.0) < room) & ((abs(y - F(piece.low_height)) < slack) |
                                                  (abs(y - F(piece.high_height)) < slack)));
                found.insert(t, index, F(side) * slope, valid, open);
            }
        } else {  // a cone: a^2 radius^2 = (c - b height)^2
            const double a2 = piece.a * piece.a;
            const F gap = F(piece.c) - F(piece.b) * height, widening = F(-piece.b) * d.y;
            const F A = F(a2) * dd - widening * widening;
            const F B = F(a2) * ed - gap * widening;
            const F C = F(a2) * ee - gap * gap;
            const F discriminant = B * B - A * C;
            const M real = F(0.0) < discriminant;
            open = open | (abs(discriminant) < narrow_miss * F(1e-3));
            if (!any(real)) continue;
            const F root = sqrt(max(discriminant, F(0.0)));
            const F q = -(B + select(B < F(0.0), -root, root));
            for (const F& at : {q / A, C / q}) {
                // One step of Newton's method for the distance from the piece is the last word.
                F t = at, slope;
                for (int round = 0; round < 2; ++round) {
                    const F x = e.x + t * d.x, z = e.z + t * d.z;
                    const F radius = sqrt(x * x + z * z);
                    slope = F(piece.a) * (x * d.x + z * d.z) / radius + F(piece.b) * d.y;
                    if (round == 1) break;
                    const F step =
                        (F(piece.a) * radius + F(piece.b) * (height + t * d.y) - F(piece.c)) /
                        slope;
                    open =
                        open |
                        (real & but_not(abs(at) < F(infinity), abs(step) <= F(1e-6 * solid.size)) &
                         (abs(height + t * d.y - F(0.5 * (piece.low_height + piece.high_height))) <
                          F(0.51 * (piece.high_height - piece.low_height))));
                    t = select(abs(step) <= F(1e-6 * solid.size), t - step, t);
                }
                const F y = height + t * d.y;
                const F x = e.x + t * d.x, z = e.z + t * d.z;
                // Of the two halves of the cone only one is meant.
                const M meant = (F(0.0) <= F(piece.a) * (F(piece.c) - F(piece.b) * y)) &
                                (x * x + z * z < F(1.01 * piece.high_radius * piece.high_radius));
                const M valid =
                    real & meant & (F(piece.low_height) <= y) & (y < F(piece.high_height));
                open = open | (real & meant &
                               ((abs(y - F(piece.low_height)) < slack) |
                                (abs(y - F(piece.high_height)) < slack)));
                found.insert(t, index, slope, valid, open);
            }
        }
    }
    open = open | steep;
    for (int k = 1; k < most_lathe_crossings; ++k)
        open = open | ((found.t[k] < F(infinity)) & (found.t[k] - found.t[k - 1] < slack));
    for (int k = 0; k < most_lathe_crossings; ++k) {
        found.t[k] = found.t[k] + shift;
        if (solid.placed) found.t[k] = found.t[k] / length;
    }
    unsure = unsure | open;
    settle(program, solid, rays, known, inside, found, first, second, unsure);
}

/// The lanes whose rays a foreign solid must be asked about: they meet the sphere around it before
/// what is nearest so far, or it stands in their list or contacts.
HWY_INLINE M near_foreign(const Solid& solid, const Rays& rays, M named, F nearest) {
    const F3 e = rays.world.origin - F3(solid.center);
    const F b = dot(e, rays.world.direction);
    const F3 f = e - b * rays.world.direction;
    const F room = F(solid.radius * solid.radius) - dot(f, f);
    const F bound = nearest * F(1.0 + 1e-6) + F(1e-6) * (rays.largest + F(solid.radius));
    const M met = (F(0.0) < room) & ((b < F(0.0)) | (b * b < room)) &
                  ((-b < bound) | ((b + bound) * (b + bound) < room));
    return rays.active & (named | met);
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
