#include <cmath>

#include "tests/geom/referee.hpp"

namespace meniscus::geom {

namespace {

using oracle::absolute;
using oracle::Extended;
using oracle::square_root;

/// One piece of the profile as two polynomials in u.
struct Curve {
    std::vector<Quad> x, y;

    bool is_straight() const { return x[2] == 0 && y[2] == 0 && x[3] == 0 && y[3] == 0; }
    static Quad value(const std::vector<Quad>& c, Quad u) {
        return ((c[3] * u + c[2]) * u + c[1]) * u + c[0];
    }
    static Quad slope(const std::vector<Quad>& c, Quad u) {
        return (3 * c[3] * u + 2 * c[2]) * u + c[1];
    }
};

/// What each point contributes to the coefficients of 1, u, u^2, u^3.
using Basis = std::vector<std::array<double, 4>>;

const Basis linear{{1, -1, 0, 0}, {0, 1, 0, 0}};
const Basis quadratic{{0, -0.5, 0.5, 0}, {1, 0, -1, 0}, {0, 0.5, 0.5, 0}};  // through -1, 0, 1
const Basis catmull_rom{
    {0, -0.5, 1, -0.5}, {1, 0, -2.5, 1.5}, {0, 0.5, 2, -1.5}, {0, 0, -0.5, 0.5}};
const Basis bernstein{{1, -3, 3, -1}, {0, 3, -6, 3}, {0, 0, 3, -3}, {0, 0, 0, 1}};

Curve combined(const Basis& basis, const Vec2* points) {
    Curve curve{std::vector<Quad>(4), std::vector<Quad>(4)};
    for (std::size_t k = 0; k < basis.size(); ++k) {
        for (int i = 0; i < 4; ++i) {
            curve.x[i] += Quad(basis[k][i]) * Quad(points[k].x);
            curve.y[i] += Quad(basis[k][i]) * Quad(points[k].y);
        }
    }
    return curve;
}

class ExactLathe : public ExactShape {
public:
    explicit ExactLathe(const Lathe& lathe) {
        const auto& p = lathe.points();
        const auto add = [&](const Basis& basis, std::size_t first) {
            curves_.push_back(combined(basis, &p[first]));
        };
        for (std::size_t i = 0; i < p.size(); ++i) {
            size_ = std::fmax(size_, std::fmax(std::fabs(p[i].x), std::fabs(p[i].y)));
            switch (lathe.spline()) {
                case Spline::linear:
                    if (i + 1 < p.size() && p[i] != p[i + 1]) add(linear, i);
                    break;
                case Spline::quadratic:
                    if (i + 2 < p.size()) add(quadratic, i);
                    break;
                case Spline::cubic:
                    if (i + 3 < p.size()) add(catmull_rom, i);
                    break;
                case Spline::bezier:
                    if (i % 4 == 0) add(bernstein, i);
                    break;
            }
        }
    }

    void meet(const QuadVec& o, const QuadVec& d, std::vector<Meeting>& out) const override {
        // From the point nearest to the origin, with a unit direction.
        const Quad length = square_root(dot(d, d));
        const QuadVec f = (Quad(1) / length) * d;
        const Quad shift = -dot(o, f);
        const QuadVec e = o + shift * f;
        std::vector<Meeting> here;
        for (std::size_t i = 0; i < curves_.size(); ++i)
            meet_curve(curves_[i], e, f, Face(i), here);
        for (const Meeting& m : here) out.push_back({(shift + m.t) / length, m.face});
    }

    /// Even-odd along an outward line a hair above the point.
    bool contains(const QuadVec& p) const override {
        const Quad radius = square_root(p.x * p.x + p.z * p.z);
        const Quad height = p.y + Quad(size_) * Quad(1e-30);
        bool inside = false;
        for (const Curve& curve : curves_) {
            for (const Quad u : crossings_of_height(curve, height)) {
                if (Curve::value(curve.x, u) > radius) inside = !inside;
            }
        }
        return inside;
    }

    QuadVec gradient(Face face, const QuadVec& p) const override {
        const Curve& curve = curves_[std::size_t(face)];
        const auto radius = double(square_root(p.x * p.x + p.z * p.z)), height = double(p.y);
        double best = 0.0, least = HUGE_VAL;
        const auto gap = [&](double u) {
            return std::hypot(double(Curve::value(curve.x, u)) - radius,
                              double(Curve::value(curve.y, u)) - height);
        };
        for (int i = 0; i <= 64; ++i) {
            if (gap(i / 64.0) < least) least = gap(best = i / 64.0);
        }
        for (double step = 1.0 / 64.0; step > 1e-12; step *= 0.5) {
            for (const double u : {best - step, best + step}) {
                if (u >= 0.0 && u <= 1.0 && gap(u) < least) least = gap(best = u);
            }
        }
        const Quad nx = Curve::slope(curve.y, best), ny = -Curve::slope(curve.x, best);
        const Quad r = radius > 0.0 ? Quad(radius) : Quad(1);
        return {nx * p.x / r, ny, nx * p.z / r};
    }

private:
    /// Where the curve passes the height, each time once: half open at its joints.
    static std::vector<Quad> crossings_of_height(const Curve& curve, Quad height) {
        Quad low = curve.y[0], high = curve.y[0], reach = 0;
        for (int i = 1; i < 4; ++i) reach += absolute(curve.y[i]);
        low -= reach;
        high += reach;
        if (height < low || height > high) return {};
        std::vector<Quad> shifted = curve.y;
        shifted[0] -= height;
        return sign_changes(shifted, Quad(0), Quad(1));
    }

    static void meet_circle(const QuadVec& e, const QuadVec& d, Quad radius, Face face, Quad u,
                            const Curve& curve, std::vector<Meeting>& out) {
        const Quad a = d.x * d.x + d.z * d.z, b = e.x * d.x + e.z * d.z,
                   c = e.x * e.x + e.z * e.z - radius * radius;
        if (a == 0) return;
        const Quad discriminant = b * b - a * c;
        const Quad root = discriminant > 0 ? square_root(discriminant) : Quad(0);
        for (const Quad side : {root, Quad(-root)})
            polish(e, d, curve, u, (side - b) / a, face, out);
    }

    /// With n = (y', -x'): n.x radius = n.(x, y) - n.y height, both sides squared.
    static void meet_cone(const Curve& curve, const QuadVec& e, const QuadVec& d, Face face,
                          std::vector<Meeting>& out) {
        const Quad nx = curve.y[1], ny = -curve.x[1], c = nx * curve.x[0] + ny * curve.y[0];
        if (nx == 0) {
            if (d.y != 0) out.push_back({(curve.y[0] - e.y) / d.y, face});
            return;
        }
        const Quad width = c - ny * e.y, widening = -ny * d.y;
        const Quad A = nx * nx * (d.x * d.x + d.z * d.z) - widening * widening,
                   B = nx * nx * (e.x * d.x + e.z * d.z) - width * widening,
                   C = nx * nx * (e.x * e.x + e.z * e.z) - width * width;
        Quad discriminant = B * B - A * C;
        if (discriminant < 0) {
            if (A > 0) return;
            discriminant = 0;
        }
        const Quad root = square_root(discriminant), q = B < 0 ? -B + root : -B - root;
        if (A != 0) out.push_back({q / A, face});
        if (q != 0) out.push_back({C / q, face});
    }

    /// Newton's method for "the line at t is the curve at u".
    static void polish(const QuadVec& e, const QuadVec& d, const Curve& curve, Quad u, Quad t,
                       Face face, std::vector<Meeting>& out) {
        for (int i = 0; i < 6; ++i) {
            const Quad x = Curve::value(curve.x, u), px = e.x + t * d.x, pz = e.z + t * d.z;
            const Quad g = px * px + pz * pz - x * x;
            const Quad h = e.y + t * d.y - Curve::value(curve.y, u);
            const Quad gt = 2 * (px * d.x + pz * d.z), gu = -2 * x * Curve::slope(curve.x, u);
            const Quad ht = d.y, hu = -Curve::slope(curve.y, u);
            const Quad determinant = gt * hu - gu * ht;
            if (determinant == 0) break;
            const Quad dt = (g * hu - gu * h) / determinant, du = (gt * h - g * ht) / determinant;
            if (!(absolute(du) < Quad(1e-3))) break;
            t -= dt;
            u -= du;
        }
        out.push_back({t, face});
    }

    void meet_curve(const Curve& curve, const QuadVec& e, const QuadVec& d, Face face,
                    std::vector<Meeting>& out) const {
        if (curve.is_straight()) return meet_cone(curve, e, d, face, out);
        // Across the axis, or nearly so, the height alone tells where, and Newton's method the
        // rest.
        if (absolute(d.y) < Quad(1e-9)) {
            std::vector<Quad> y = curve.y;
            y[0] -= e.y + Quad(size_) * Quad(1e-30);
            for (const Quad u : sign_changes(y, Quad(-1e-6), Quad(1) + Quad(1e-6)))
                meet_circle(e, d, Curve::value(curve.x, u), face, u, curve, out);
        }
        if (d.y == 0) return;
        // With t = (y - e.y) / d.y put into |across|^2 = x^2:
        // d.y^2 (ee - x^2) + 2 d.y ed (y - e.y) + dd (y - e.y)^2 = 0
        const Quad dd = d.x * d.x + d.z * d.z, ed = e.x * d.x + e.z * d.z,
                   ee = e.x * e.x + e.z * e.z;
        std::vector<Quad> f(7), y = curve.y;
        y[0] -= e.y;
        for (int i = 0; i < 4; ++i) {
            f[i] += 2 * d.y * ed * y[i];
            for (int j = 0; j < 4; ++j)
                f[i + j] += dd * y[i] * y[j] - d.y * d.y * curve.x[i] * curve.x[j];
        }
        f[0] += d.y * d.y * ee;
        while (f.size() > 1 && f.back() == 0) f.pop_back();
        for (const Quad u : sign_changes(f, Quad(0), Quad(1)))
            polish(e, d, curve, u, Curve::value(y, u) / d.y, face, out);
        // A line through the very end of a piece on the axis only touches.
        for (const Quad u : {Quad(0), Quad(1)}) {
            if (Curve::value(curve.x, u) == 0) out.push_back({Curve::value(y, u) / d.y, face});
        }
    }

    std::vector<Curve> curves_;
    double size_ = 0.0;
};

}  // namespace

std::unique_ptr<ExactShape> exact_lathe(const Lathe& lathe) {
    return std::make_unique<ExactLathe>(lathe);
}

}  // namespace meniscus::geom
