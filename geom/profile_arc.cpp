#include "geom/profile_arc.hpp"

#include <algorithm>

#include "geom/polynomial.hpp"
#include "geom/profile.hpp"

namespace meniscus::geom {

namespace {

/// Coefficients are taken over from a piece to its arcs with more digits than they are kept with.
using Extended = long double;

struct Cubic {
    Extended c0, c1, c2, c3;

    Extended at(Extended u) const { return ((c3 * u + c2) * u + c1) * u + c0; }
    Extended slope(Extended u) const { return (3 * c3 * u + 2 * c2) * u + c1; }
};

Cubic component(const ProfilePiece& piece, int axis) {
    return {piece.c[0][axis], piece.c[1][axis], piece.c[2][axis], piece.c[3][axis]};
}

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

/// Roots in (0, 1) of a polynomial whose leading coefficients may vanish.
void append_roots(std::span<const double> c, std::vector<double>& out) {
    while (c.size() > 1 && c.back() == 0.0) c = c.first(c.size() - 1);
    for (const double u : roots_between(c, 0.0, 1.0)) {
        if (u > 0.0 && u < 1.0) out.push_back(u);
    }
}

/// Where a piece turns back in radius or height, changes the side it bends to, or meets the axis.
std::vector<double> cuts(const ProfilePiece& piece) {
    const auto& c = piece.c;
    std::vector<double> result;
    for (int axis = 0; axis < 2; ++axis) {
        append_roots(std::array{c[1][axis], 2.0 * c[2][axis], 3.0 * c[3][axis]}, result);
    }
    // c' x c'' = 0
    append_roots(std::array{cross(c[1], c[2]), 3.0 * cross(c[1], c[3]), 3.0 * cross(c[2], c[3])},
                 result);
    if (piece.low.x < 0.0) append_roots(std::array{c[0].x, c[1].x, c[2].x, c[3].x}, result);
    std::sort(result.begin(), result.end());
    return result;
}

/// Least and greatest value on [0, 1] of c[0] + c[1] v + c[2] v^2, or beyond: of its Bernstein
/// coefficients.
std::array<double, 2> range(const std::array<double, 3>& c) {
    const auto [low, high] = std::minmax({c[0], c[0] + 0.5 * c[1], c[0] + c[1] + c[2]});
    return {low, high};
}

class ArcMaker {
public:
    ArcMaker(const ProfilePiece& piece, Face index, std::vector<ProfileArc>& out)
        : piece_(piece),
          index_(index),
          x_(component(piece, 0)),
          y_(component(piece, 1)),
          reach_(glm::length(piece.high - piece.low)),
          out_(out) {}

    Vec2 at(double u) const {
        return {static_cast<double>(x_.at(u)), static_cast<double>(y_.at(u))};
    }

    void add(double u0, Vec2 start, double u1, Vec2 end, int splits = 48) {
        start.x = glm::max(start.x, 0.0);
        end.x = glm::max(end.x, 0.0);
        if (start == end) return;
        const bool is_long = glm::length(end - start) > 1e-14 * reach_;
        if (!piece_.straight && is_long && splits > 0 && turns_much(u0, u1, end - start)) {
            const double middle = farthest(u0, u1, end - start);
            const Vec2 p = at(middle);
            add(u0, start, middle, p, splits - 1);
            add(middle, p, u1, end, splits - 1);
            return;
        }
        out_.push_back(made(u0, start, u1, end));
    }

private:
    Vec2 tangent(double u) const {
        return {static_cast<double>(x_.slope(u)), static_cast<double>(y_.slope(u))};
    }
    /// At a cusp: the direction just within.
    Vec2 tangent_within(double u, double other) const {
        const Vec2 there = tangent(u), within = tangent(u + 1e-6 * (other - u));
        return glm::length(there) < 1e-8 * glm::length(within) ? within : there;
    }

    /// By more than arctan 1/2 from the chord.
    bool turns_much(double u0, double u1, const Vec2& chord) const {
        for (const Vec2& t : {tangent_within(u0, u1), tangent_within(u1, u0)}) {
            if (!(glm::abs(cross(chord, t)) <= 0.5 * glm::dot(chord, t))) return true;
        }
        return false;
    }

    /// Where the curve is farthest from its chord.
    double farthest(double u0, double u1, const Vec2& chord) const {
        const auto& c = piece_.c;
        std::vector<double> found;
        append_roots(
            std::array{cross(chord, c[1]), 2.0 * cross(chord, c[2]), 3.0 * cross(chord, c[3])},
            found);
        const double margin = 0.05 * (u1 - u0);
        for (const double u : found) {
            if (u > u0 + margin && u < u1 - margin) return u;
        }
        return 0.5 * (u0 + u1);
    }

    ProfileArc made(double u0, const Vec2& start, double u1, const Vec2& end) const {
        ProfileArc arc;
        arc.piece = index_;
        arc.start = start;
        arc.end = end;
        arc.length = glm::length(end - start);
        arc.chord = (end - start) / arc.length;
        arc.normal = {arc.chord.y, -arc.chord.x};
        if (arc.normal.x < 0.0 || (arc.normal.x == 0.0 && arc.normal.y < 0.0)) {
            arc.normal = -arc.normal;
        }
        const double inner = glm::min(start.x, end.x), outer = glm::max(start.x, end.x);
        arc.inner2 = inner * inner;
        arc.outer2 = outer * outer;
        arc.kind = ProfileArc::Kind::straight;
        if (piece_.straight) return arc;

        // c(u0 + v (u1 - u0)), turned into the frame of the chord
        const Extended width = Extended{u1} - u0;
        std::array<std::array<Extended, 3>, 2> c;
        int axis = 0;
        for (const Cubic& k : {x_, y_}) {
            c[axis++] = {width * k.slope(u0), width * width * (k.c2 + 3 * k.c3 * u0),
                         width * width * width * k.c3};
        }
        for (int i = 0; i < 3; ++i) {
            arc.along[i] = static_cast<double>(arc.chord.x * c[0][i] + arc.chord.y * c[1][i]);
            arc.rise[i] = static_cast<double>(arc.normal.x * c[0][i] + arc.normal.y * c[1][i]);
        }
        const auto slope = [&](const Vec2& t) {
            return glm::dot(arc.normal, t) / glm::dot(arc.chord, t);
        };
        arc.slope_start = slope(tangent_within(u0, u1));
        arc.slope_end = slope(tangent_within(u1, u0));
        const auto pace = [&](Extended speed) {
            // Towards a cusp it grows without bounds.
            return glm::min(arc.length / static_cast<double>(speed), 3.0);
        };
        arc.start_pace = pace(arc.along[0]);
        arc.end_pace = pace(arc.along[0] + 2.0 * arc.along[1] + 3.0 * arc.along[2]);
        const double middle = (0.125 * arc.rise[2] + 0.25 * arc.rise[1]) + 0.5 * arc.rise[0];
        // The control points' rises, of which that of the curve is a mean
        const double rise1 = arc.rise[0] / 3.0, rise2 = (2.0 * arc.rise[0] + arc.rise[1]) / 3.0;
        arc.least_rise = glm::min(0.0, glm::min(rise1, rise2));
        arc.greatest_rise = glm::max(0.0, glm::max(rise1, rise2));
        arc.kind = middle >= 0.0 ? ProfileArc::Kind::bulging : ProfileArc::Kind::hollow;

        // The second derivative of the rise: (h'' s' - h' s'') / s'^3
        const auto& [s1, s2, s3] = arc.along;
        const auto& [h1, h2, h3] = arc.rise;
        const auto [low, high] = range(
            {2.0 * (h2 * s1 - h1 * s2), 6.0 * (h3 * s1 - h1 * s3), 6.0 * (h3 * s2 - h2 * s3)});
        const auto [slow, fast] = range({s1, 2.0 * s2, 3.0 * s3});
        const double sign = arc.kind == ProfileArc::Kind::hollow ? 1.0 : -1.0;
        const auto [least, greatest] = std::minmax({sign * low, sign * high});
        arc.least_bend = glm::max(least, 0.0) / (fast * fast * fast);
        arc.greatest_bend = slow > 0.0 ? glm::max(greatest, 0.0) / (slow * slow * slow) : infinity;
        return arc;
    }

    const ProfilePiece& piece_;
    Face index_;
    Cubic x_, y_;
    double reach_;  // shorter than rounding needs no cutting
    std::vector<ProfileArc>& out_;
};

}  // namespace

ProfileArc::Rise ProfileArc::rise_at(double s, double& v) const {
    if (kind == Kind::straight) return {0.0, 0.0};
    if (!(s > 0.0)) return {slope_start * s, slope_start};
    if (!(s < length)) return {slope_end * (s - length), slope_end};
    if (!(v > 0.0 && v < 1.0)) {
        const double x = s / length, rest = 1.0 - x;
        v = x + x * rest * ((start_pace - 1.0) * rest - (end_pace - 1.0) * x);
    }
    // along(v) = s by Chebyshev's method (Newton's step and the next term), halving where it would
    // leave the bracket.
    double low = 0.0, high = 1.0, speed = 0.0;
    for (int i = 0; i < 60; ++i) {
        const double off = ((along[2] * v + along[1]) * v + along[0]) * v - s;
        const double half_change = 3.0 * along[2] * v + along[1];
        speed = (half_change + along[1]) * v + along[0];
        (off < 0.0 ? low : high) = v;
        const double per_speed = 1.0 / speed, step = off * per_speed;
        const double next = v - step - step * (step * half_change * per_speed);
        const bool is_last = glm::abs(step) <= 1e-6;  // what then is left is its cube
        v = is_last || (next > low && next < high) ? next : 0.5 * (low + high);
        if (is_last) break;
    }
    speed = (3.0 * along[2] * v + 2.0 * along[1]) * v + along[0];
    const double climb = (3.0 * rise[2] * v + 2.0 * rise[1]) * v + rise[0];
    // At a cusp neither is anything.
    const double slope = speed > 1e-6 * length ? climb / speed : v < 0.5 ? slope_start : slope_end;
    return {((rise[2] * v + rise[1]) * v + rise[0]) * v, slope};
}

void append_arcs(const ProfilePiece& piece, Face index, std::vector<ProfileArc>& out) {
    ArcMaker maker(piece, index, out);
    double from = 0.0;
    Vec2 start = piece.start;
    const auto arc_to = [&](double to, const Vec2& end) {
        if (maker.at(0.5 * (from + to)).x >= 0.0) maker.add(from, start, to, end);
        from = to;
        start = end;
    };
    if (!piece.straight) {
        const double rounding = 16.0 * unit_roundoff * piece.high.x;
        for (const double u : cuts(piece)) {
            Vec2 p = maker.at(u);
            if (p.x <= rounding) p.x = 0.0;
            arc_to(u, p);
        }
    }
    arc_to(1.0, piece.end);
}

}  // namespace meniscus::geom
