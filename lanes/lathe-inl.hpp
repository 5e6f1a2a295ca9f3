// Crossings with solids that are not convex, in lanes: lathes with straight pieces, and what sorted
// crossings mean to rays whose list is known.

#if defined(MENISCUS_LANES_LATHE) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_LATHE
#undef MENISCUS_LANES_LATHE
#else
#define MENISCUS_LANES_LATHE
#endif

#include "lanes/spans-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

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

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
