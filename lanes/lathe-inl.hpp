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
};

/// Crossings of a line with a lathe while they are gathered: slope and piece share a word, the
/// piece in the last bits of the mantissa.
class GatheredCrossings {
public:
    HWY_INLINE GatheredCrossings() {
        for (int k = 0; k < most_lathe_crossings; ++k) {
            t_[k] = F(infinity);
            key_[k] = F(0.0);
        }
    }

    HWY_INLINE void insert(F t, std::size_t piece, F slope, M valid, M& unsure) {
        F at = select(valid, t, F(infinity));
        F key = with_bits(slope, piece);
        for (int k = 0; k < std::min(count_ + 1, most_lathe_crossings); ++k) {
            const M sooner = at < t_[k];
            const F later = select(sooner, key_[k], key);
            key_[k] = select(sooner, key, key_[k]);
            key = later;
            const F first = min(at, t_[k]);
            at = max(at, t_[k]);
            t_[k] = first;
        }
        if (count_++ >= most_lathe_crossings) unsure = unsure | (at < F(infinity));
    }

    HWY_INLINE LatheCrossings sorted() const {
        LatheCrossings result;
        for (int k = 0; k < most_lathe_crossings; ++k) {
            result.t[k] = t_[k];
            result.slope[k] = key_[k];
            result.piece[k] = to_double(as_words(key_[k]) & U(15));
        }
        return result;
    }

private:
    static HWY_INLINE F with_bits(F x, std::size_t low) {
        return as_doubles((as_words(x) & U(~15ull)) | U(std::uint64_t(low)));
    }

    F t_[most_lathe_crossings], key_[most_lathe_crossings];
    int count_ = 0;
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
    const F3 from_middle = ray.origin - F3(geom::Vec3{0.0, solid.height, 0.0});
    const F shift = -dot(from_middle, d);
    const F3 e = from_middle + shift * d;
    const F height = e.y + F(solid.height);
    const F dd = d.x * d.x + d.z * d.z, ed = e.x * d.x + e.z * d.z, ee = e.x * e.x + e.z * e.z;
    const M steep = dd < F(1e-12);  // along the axis
    const F per_dd = F(1.0) / dd;
    const F b = ed * per_dd;
    const F fx = e.x - b * d.x, fz = e.z - b * d.z;
    const F ff = fx * fx + fz * fz;
    const F per_dy = F(1.0) / d.y;
    const F slack(1e-9 * solid.size);

    GatheredCrossings gathered;
    M open = no_lanes();  // lanes for which these crossings are not sure
    const F narrow_miss(solid.size * solid.size * 1e-9);
    for (std::size_t i = 0; i < solid.pieces.size(); ++i) {
        const Piece& piece = solid.pieces[i];
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
            gathered.insert(t, i, F(piece.b) * d.y, valid, open);
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
                gathered.insert(t, i, F(side) * slope, valid, open);
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
                gathered.insert(t, i, slope, valid, open);
            }
        }
    }
    LatheCrossings found = gathered.sorted();
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
