#include "geom/lathe.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geom/alternate.hpp"
#include "geom/polynomial.hpp"
#include "geom/profile.hpp"

namespace meniscus::geom {

namespace {

/// Roots a little beyond the ends of a piece are candidates too, so that none is lost at a joint.
constexpr double overhang = 1e-9;

/// A line with unit direction, seen from its point nearest to the middle of the lathe: t of the ray
/// is (shift + t) / length.
struct LatheLine {
    double length, shift;
    AxialRay ray;
    double dd, ed, ee;  // products of the parts across the axis

    LatheLine(const Ray& whole, double middle) : length(glm::length(whole.direction)) {
        const Vec3 d = whole.direction / length, from_middle = whole.from({0.0, middle, 0.0});
        shift = -glm::dot(from_middle, d);
        const Vec3 e = from_middle + shift * d;
        ray = {e.y + middle, d.y, {e.x, 0.0, e.z}, {d.x, 0.0, d.z}};
        dd = glm::dot(ray.across_d, ray.across_d);
        ed = glm::dot(ray.across_e, ray.across_d);
        ee = glm::dot(ray.across_e, ray.across_e);
    }

    Vec2 at(double t) const {
        return {glm::length(ray.across_e + t * ray.across_d), ray.along_e + t * ray.along_d};
    }
};

/// Solves A t^2 + 2 B t + C = 0, for the part of a line within a cone; a line that only touches
/// gives none. Where A < 0 the line meets both halves of a cone, and only rounding can deny that:
/// then it passes through the point.
Roots quadratic(double A, double B, double C) {
    Roots roots;
    double discriminant = B * B - A * C;
    if (!(discriminant > 0.0)) {
        if (!(A < 0.0)) return roots;
        discriminant = 0.0;
    }
    const double q = -(B + std::copysign(glm::sqrt(discriminant), B));
    if (A != 0.0) roots.push_back(q / A);
    if (q != 0.0) roots.push_back(C / q);
    return roots;
}

void straight_candidates(const LatheLine& line, const ProfilePiece& piece, double size, Face face,
                         Candidates& out) {
    const double a = piece.line.a, b = piece.line.b;
    const double slack = overhang * size;
    const auto keep = [&](double t) {
        t = piece.line.polish(line.ray, t, 1e-6 * size);
        const Vec2 p = line.at(t);
        if (p.x >= piece.low.x - slack && p.x <= piece.high.x + slack &&
            p.y >= piece.low.y - slack && p.y <= piece.high.y + slack) {
            out.push_back({t, face});
        }
    };
    if (a == 0.0) {
        if (line.ray.along_d != 0.0) keep((piece.start.y - line.ray.along_e) / line.ray.along_d);
        return;
    }
    // a^2 radius^2 = (c - b height)^2, with heights from the narrower end
    const Vec2& narrow = piece.start.x <= piece.end.x ? piece.start : piece.end;
    const double height = line.ray.along_e - narrow.y;
    const double widening = -b * line.ray.along_d, a2 = a * a;
    const double A = a2 * line.dd - widening * widening;
    const auto solve_from = [&](double shift) {
        Vec3 across;
        double width, B;
        const auto see_from_shift = [&] {
            across = line.ray.across_e + shift * line.ray.across_d;
            width = a * narrow.x - b * (height + shift * line.ray.along_d);
            B = a2 * glm::dot(across, line.ray.across_d) - width * widening;
        };
        see_from_shift();
        if (glm::abs(B) < 4.0 * size * A) {  // from halfway between the roots, as in cone.cpp
            shift -= B / A;
            see_from_shift();
        }
        for (const double t : quadratic(A, B, a2 * glm::dot(across, across) - width * width)) {
            keep(shift + t);
        }
    };
    // A flat cone is solved from where the line meets its middle height: there its two branches do
    // not drown in the constants. Any other, and about its point a flat one too, from the point of
    // the line nearest to the narrower end.
    const bool is_flat = glm::abs(a) < 0.1 && glm::abs(line.ray.along_d) > 1e-3;
    if (is_flat) {
        solve_from((0.5 * (piece.end.y + piece.start.y) - line.ray.along_e) / line.ray.along_d);
    }
    if (!is_flat || narrow.x == 0.0) solve_from(-(line.ed + height * line.ray.along_d));
}

/// Newton's method for "the line at t is the curve at u".
void polish(const LatheLine& line, const ProfilePiece& piece, double& u, double& t) {
    for (int i = 0; i < 3; ++i) {
        const Vec2 gap = line.at(t) - piece.at(u), along = piece.tangent(u);
        const Vec3 across = line.ray.across_e + t * line.ray.across_d;
        const double radius = glm::length(across);
        if (!(radius > 0.0)) return;
        const Vec2 way{glm::dot(across, line.ray.across_d) / radius, line.ray.along_d};
        const double determinant = along.x * way.y - along.y * way.x;
        const double du = (gap.x * way.y - gap.y * way.x) / determinant;
        const double dt = (gap.x * along.y - gap.y * along.x) / determinant;
        if (!(glm::abs(du) < 0.01)) return;
        u += du;
        t += dt;
    }
}

void curved_candidates(const LatheLine& line, const ProfilePiece& piece, double size, Face face,
                       Candidates& out) {
    const double dy = line.ray.along_d;
    const auto keep = [&](double u, double t) {
        polish(line, piece, u, t);
        if (u < -overhang || u > 1.0 + overhang) return;
        if (glm::length(line.at(t) - piece.at(u)) < 1e-6 * size) out.push_back({t, face});
    };
    std::array<double, 4> x, y;  // of the piece; y from the line's origin
    for (int i = 0; i < 4; ++i) {
        x[i] = piece.c[i].x;
        y[i] = piece.c[i].y;
    }
    y[0] -= line.ray.along_e;

    // With t = y / dy put into |across|^2 = x^2:  dy^2 (x^2 - ee) - 2 dy ed y - dd y^2 = 0.
    std::array<double, 7> f{};
    for (int i = 0; i < 4; ++i) {
        f[i] -= 2.0 * dy * line.ed * y[i];
        for (int j = 0; j < 4; ++j) f[i + j] += dy * dy * x[i] * x[j] - line.dd * y[i] * y[j];
    }
    f[0] -= dy * dy * line.ee;
    const auto by_radius = [&](double radius) {
        return quadratic(line.dd, line.ed, line.ee - radius * radius);
    };
    for (const double u : roots_between(f, -overhang, 1.0 + overhang)) {
        if (glm::abs(dy) > 0.1) {
            keep(u, evaluate(y, u) / dy);
        } else {
            for (const double t : by_radius(evaluate(x, u))) keep(u, t);
        }
    }
    // Where the curve ends on the axis f only touches 0.
    if (dy != 0.0) {
        const double slack = overhang * size;
        if (piece.start.x <= slack) keep(0.0, y[0] / dy);
        if (piece.end.x <= slack) keep(1.0, evaluate(y, 1.0) / dy);
    }
    // Across the axis, or nearly so, the roots of f fall together in pairs: the height alone tells
    // where they are.
    if (glm::abs(dy) < 1e-4) {
        for (const double u : roots_between(y, -overhang, 1.0 + overhang)) {
            for (const double t : by_radius(evaluate(x, u))) keep(u, t);
        }
    }
}

/// Whether the line may meet the piece: it comes as near to the axis, within the piece's range of
/// heights.
bool may_meet(const LatheLine& line, const ProfilePiece& piece, double size) {
    const double slack = 1e-6 * size, reach = piece.high.x + slack;
    double from = -infinity, to = infinity;
    const double low = piece.low.y - slack - line.ray.along_e;
    const double high = piece.high.y + slack - line.ray.along_e;
    if (line.ray.along_d == 0.0) {
        if (low > 0.0 || high < 0.0) return false;
    } else {
        from = glm::min(low / line.ray.along_d, high / line.ray.along_d);
        to = glm::max(low / line.ray.along_d, high / line.ray.along_d);
    }
    const double nearest = line.dd > 1e-30 ? glm::clamp(-line.ed / line.dd, from, to) : 0.0;
    const Vec3 across = line.ray.across_e + nearest * line.ray.across_d;
    return glm::dot(across, across) <= reach * reach;
}

Candidates candidates(const LatheLine& line, const Profile& profile) {
    Candidates found;
    const auto& pieces = profile.pieces();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (!may_meet(line, pieces[i], profile.size())) continue;
        const auto find = pieces[i].straight ? straight_candidates : curved_candidates;
        find(line, pieces[i], profile.size(), static_cast<Face>(i), found);
    }
    return found;
}

Vec2 radius_and_height(const Vec3& p) { return {glm::length(Vec2{p.x, p.z}), p.y}; }

}  // namespace

Lathe::Lathe()
    : Lathe(Spline::linear,
            {{0.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {0.75, 1.0}, {0.75, -0.75}, {0.0, -0.75}}) {}

Lathe::Lathe(Spline spline, std::vector<Vec2> points)
    : spline_(spline),
      points_(std::move(points)),
      profile_(std::make_shared<const Profile>(spline_, points_)) {}

bool Lathe::is_closed() const { return profile_->is_closed(); }

Bounds Lathe::bounds() const {
    const double radius = profile_->high().x;
    return {{-radius, profile_->low().y, -radius}, {radius, profile_->high().y, radius}};
}

double Lathe::magnitude() const {
    const Bounds box = bounds();
    return glm::max(max_abs(box.low), max_abs(box.high));
}

void Lathe::crossings(const Ray& ray, Crossings& out) const {
    LatheLine line(ray, 0.5 * (profile_->low().y + profile_->high().y));
    Candidates found = candidates(line, *profile_);
    const double merge = 4.0 * unit_roundoff * (magnitude() + glm::abs(line.shift));
    const std::size_t before = out.size();
    keep_changes(
        found, merge, [&](double t) { return profile_->contains(line.at(t)); }, out);
    for (std::size_t i = before; i < out.size(); ++i) {
        out[i].t = (line.shift + out[i].t) / line.length;
    }
}

void Lathe::hits(const Ray& ray, Crossings& out) const {
    if (is_closed()) return crossings(ray, out);
    LatheLine line(ray, 0.5 * (profile_->low().y + profile_->high().y));
    Candidates found = candidates(line, *profile_);
    std::sort(found.begin(), found.end(), [](auto a, auto b) { return a.t < b.t; });
    const double merge = 1e-9 * profile_->size();  // at a joint both pieces are met
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (i > 0 && found[i].t - found[i - 1].t <= merge) continue;
        const double t = (line.shift + found[i].t) / line.length;
        const Vec3 n = normal(found[i].face, ray.at(t));
        out.push_back({t, found[i].face, glm::dot(n, ray.direction) < 0.0});
    }
}

bool Lathe::contains(const Vec3& p) const { return profile_->contains(radius_and_height(p)); }

Vec3 Lathe::normal(Face face, const Vec3& p) const {
    const ProfilePiece& piece = profile_->pieces()[face];
    const Vec2 q = radius_and_height(p), n = piece.normal(piece.nearest(q));
    const Vec2 out = q.x > 0.0 ? Vec2{p.x, p.z} / q.x : Vec2{1.0, 0.0};
    return glm::normalize(Vec3{n.x * out.x, n.y, n.x * out.y});
}

Vec3 Lathe::to_face(Face face, const Ray& point) const {
    const ProfilePiece& piece = profile_->pieces()[face];
    const Vec3 p = point.from(Vec3{0.0});
    const Vec2 q = radius_and_height(p);
    // The correction is along the normal: at the end of a piece the nearest point would be its end.
    const double u = piece.nearest(q);
    const Vec2 n = piece.normal(u);
    const double distance = piece.straight ? (piece.line.distance(q.x, q.y)) * piece.outward
                                           : glm::dot(q - piece.at(u), n);
    return -distance * normal(face, p);
}

}  // namespace meniscus::geom
