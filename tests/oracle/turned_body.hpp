#pragma once

#include <array>
#include <vector>

#include "geom/lathe.hpp"
#include "tests/oracle/real.hpp"
#include "tests/oracle/roots.hpp"

namespace meniscus::oracle {

/// A lathe: its profile as polynomials in u from 0 to 1, radius and height, and the region that
/// they bound by counting.
template <class Real>
class TurnedBody {
public:
    using V = Vector<Real>;

    explicit TurnedBody(const geom::Lathe& lathe) {
        const auto& p = lathe.points();
        const auto at = [&](std::size_t i) { return Flat{Real(p[i].x), Real(p[i].y)}; };
        const Real half = Real(1) / 2;
        switch (lathe.spline()) {
            case geom::Spline::linear:
                for (std::size_t i = 0; i + 1 < p.size(); ++i)
                    add(at(i), at(i + 1) - at(i), {}, {});
                break;
            case geom::Spline::quadratic:
                for (std::size_t i = 1; i + 1 < p.size(); ++i) {
                    const Flat a = at(i - 1), b = at(i), c = at(i + 1);
                    add(b, half * (c - a), half * a - b + half * c, {});
                }
                break;
            case geom::Spline::cubic:
                for (std::size_t i = 1; i + 2 < p.size(); ++i) {
                    const Flat a = at(i - 1), b = at(i), c = at(i + 1), d = at(i + 2);
                    add(b, half * (c - a), half * (Real(2) * a - Real(5) * b + Real(4) * c - d),
                        half * (Real(3) * b - a - Real(3) * c + d));
                }
                break;
            case geom::Spline::bezier:
                for (std::size_t i = 0; i + 3 < p.size(); i += 4) {
                    const Flat a = at(i), b = at(i + 1), c = at(i + 2), d = at(i + 3);
                    add(a, Real(3) * (b - a), Real(3) * (a - Real(2) * b + c),
                        d - a + Real(3) * (b - c));
                }
                break;
        }
        for (Piece& piece : pieces_) find_outward_side(piece);
    }

    bool inside(const V& p) const { return inside_profile(flat(p)); }

    template <class Emit>
    void meetings(const V& o, const V& d, Emit emit) const {
        for (std::size_t i = 0; i < pieces_.size(); ++i)
            meet(pieces_[i], o, d, [&](Real t) { emit(t, int(i)); });
    }

    V gradient(int face, const V& p) const {
        const Piece& piece = pieces_[std::size_t(face)];
        const Flat q = flat(p), n = piece.outward * normal(piece, nearest(piece, q));
        if (q.x == 0) return {n.x, n.y, Real(0)};
        return {n.x * p.x / q.x, n.y, n.x * p.z / q.x};
    }

private:
    struct Flat {  // radius and height
        Real x{0}, y{0};
        friend Flat operator+(const Flat& a, const Flat& b) { return {a.x + b.x, a.y + b.y}; }
        friend Flat operator-(const Flat& a, const Flat& b) { return {a.x - b.x, a.y - b.y}; }
        friend Flat operator*(Real s, const Flat& a) { return {s * a.x, s * a.y}; }
    };
    struct Piece {
        std::array<Flat, 4> c;
        std::vector<Real> stops;  // u at which the height turns, and 0 and 1
        Real size{0}, outward{1};
        bool is_straight() const {
            return c[2].x == 0 && c[2].y == 0 && c[3].x == 0 && c[3].y == 0;
        }
        Flat at(Real u) const { return c[0] + u * (c[1] + u * (c[2] + u * c[3])); }
        Flat tangent(Real u) const { return c[1] + u * (Real(2) * c[2] + (Real(3) * u) * c[3]); }
        std::vector<Real> xs() const { return trimmed({c[0].x, c[1].x, c[2].x, c[3].x}); }
        std::vector<Real> ys() const { return trimmed({c[0].y, c[1].y, c[2].y, c[3].y}); }
    };

    static Flat flat(const V& p) { return {square_root(Real(p.x * p.x + p.z * p.z)), p.y}; }
    static std::vector<Real> trimmed(std::vector<Real> c) {
        while (c.size() > 1 && c.back() == 0) c.pop_back();
        return c;
    }
    static std::vector<Real> product(const std::vector<Real>& a, const std::vector<Real>& b) {
        std::vector<Real> result(a.size() + b.size() - 1, Real(0));
        for (std::size_t i = 0; i < a.size(); ++i)
            for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
        return result;
    }
    static void add_scaled(std::vector<Real>& sum, Real s, const std::vector<Real>& a) {
        if (sum.size() < a.size()) sum.resize(a.size(), Real(0));
        for (std::size_t i = 0; i < a.size(); ++i) sum[i] += s * a[i];
    }

    void add(const Flat& c0, const Flat& c1, const Flat& c2, const Flat& c3) {
        Piece piece{{c0, c1, c2, c3}, {Real(0)}};
        if (piece.is_straight() && c1.x == 0 && c1.y == 0) return;
        std::vector<Real> slope = trimmed({c1.y, 2 * c2.y, 3 * c3.y});
        for (const Real u : real_roots(slope, Real(0), Real(1))) piece.stops.push_back(u);
        piece.stops.push_back(Real(1));
        for (const Flat& c : piece.c) piece.size += absolute(c.x) + absolute(c.y);
        pieces_.push_back(piece);
    }

    /// Even-odd along the outward line at the point's height; half open, so that a joint counts
    /// once.
    bool inside_profile(const Flat& p) const {
        bool inside = false;
        for (const Piece& piece : pieces_) {
            for (std::size_t i = 0; i + 1 < piece.stops.size(); ++i) {
                Real a = piece.stops[i], b = piece.stops[i + 1];
                const bool starts_below = piece.at(a).y <= p.y;
                if (starts_below == (piece.at(b).y <= p.y)) continue;
                if (piece.is_straight()) {
                    a = b = (p.y - piece.c[0].y) / piece.c[1].y;
                } else {
                    for (int step = 0; step < 200; ++step) {
                        const Real middle = (a + b) / 2;
                        if (middle == a || middle == b) break;
                        ((piece.at(middle).y <= p.y) == starts_below ? a : b) = middle;
                    }
                }
                if (piece.at(a).x > p.x) inside = !inside;
            }
        }
        return inside;
    }

    /// Every t at which the line meets the turned piece, and a little beyond its ends.
    template <class Emit>
    static void meet(const Piece& piece, const V& o, const V& d, Emit emit) {
        const Real beyond = Real(1e-9);
        const Real across = d.x * d.x + d.z * d.z, along = d.y;
        const auto by_radius = [&](Real radius) -> std::vector<Real> {
            if (across == 0) return {};
            const Real middle = -(o.x * d.x + o.z * d.z) / across;
            const Real x = o.x + middle * d.x, z = o.z + middle * d.z;
            const Real left = radius * radius - x * x - z * z;
            if (left < 0) return {};
            const Real half = square_root(Real(left / across));
            return {middle - half, middle + half};
        };
        if (along * along < Real(1e-20) * across) {
            // Nearly level: start from the height at the nearest point, and mend it.
            const Real level = across == 0 ? Real(0) : -(o.x * d.x + o.z * d.z) / across;
            for (const Real u : heights(piece, o.y + level * along, beyond)) {
                for (Real t : by_radius(piece.at(u).x)) {
                    for (int step = 0; step < 4 && along != 0; ++step) {
                        const auto us = heights(piece, o.y + t * along, beyond);
                        if (us.empty()) break;
                        Real best = us[0];
                        for (const Real other : us)
                            if (absolute(other - u) < absolute(best - u)) best = other;
                        for (const Real again : by_radius(piece.at(best).x))
                            if ((again > level) == (t > level)) t = again;
                    }
                    emit(t);
                }
            }
            return;
        }
        // t = (y(u) - o.y) / d.y put into |across|^2 = x(u)^2
        std::vector<Real> rise = piece.ys(), x{along * o.x}, z{along * o.z};
        rise[0] -= o.y;
        add_scaled(x, d.x, rise);
        add_scaled(z, d.z, rise);
        std::vector<Real> f = product(x, x);
        add_scaled(f, Real(1), product(z, z));
        add_scaled(f, -along * along, product(piece.xs(), piece.xs()));
        if (piece.is_straight() && piece.c[1].y == 0) {  // a flat ring
            emit((piece.c[0].y - o.y) / along);
            return;
        }
        f = trimmed(f);
        for (const Real u : real_roots(f, -beyond, 1 + beyond)) emit((piece.at(u).y - o.y) / along);
        // On the axis f only touches 0.
        for (const Real u : {Real(0), Real(1)})
            if (piece.at(u).x == 0) emit((piece.at(u).y - o.y) / along);
    }

    static std::vector<Real> heights(const Piece& piece, Real y, Real beyond) {
        std::vector<Real> c = piece.ys();
        c[0] -= y;
        return real_roots(c, -beyond, 1 + beyond);
    }

    static Flat normal(const Piece& piece, Real u) {
        const Flat t = piece.tangent(u);
        const Real length = square_root(Real(t.x * t.x + t.y * t.y));
        return {t.y / length, -t.x / length};
    }

    static Real nearest(const Piece& piece, const Flat& p) {
        if (piece.is_straight()) return Real(1) / 2;
        std::vector<Real> x = piece.xs(), y = piece.ys(), f;
        const auto derived = [](const std::vector<Real>& c) {
            std::vector<Real> d;
            for (std::size_t i = 1; i < c.size(); ++i) d.push_back(Real(int(i)) * c[i]);
            if (d.empty()) d.push_back(Real(0));
            return d;
        };
        const std::vector<Real> dx = derived(x), dy = derived(y);
        x[0] -= p.x;
        y[0] -= p.y;
        f = product(x, dx);
        add_scaled(f, Real(1), product(y, dy));
        std::vector<Real> tries = real_roots(trimmed(f), Real(0), Real(1));
        tries.push_back(Real(0));
        tries.push_back(Real(1));
        Real best = 0, best_distance = Real(1e300);
        for (const Real u : tries) {
            const Flat e = piece.at(u) - p;
            const Real distance = e.x * e.x + e.y * e.y;
            if (distance < best_distance) {
                best_distance = distance;
                best = u;
            }
        }
        return best;
    }

    void find_outward_side(Piece& piece) const {
        for (const Real u : {Real(0.5), Real(0.3), Real(0.7)}) {
            const Flat n = (Real(1e-9) * piece.size) * normal(piece, u);
            const bool left = inside_profile(piece.at(u) + n);
            if (left == inside_profile(piece.at(u) - n)) continue;
            piece.outward = left ? Real(-1) : Real(1);
            return;
        }
    }

    std::vector<Piece> pieces_;
};

}  // namespace meniscus::oracle
