#pragma once

#include <array>
#include <vector>

#include "geom/lathe.hpp"
#include "geom/profile_line.hpp"

namespace meniscus::geom {

/// One piece of a lathe's profile: ((c[3] u + c[2]) u + c[1]) u + c[0] for u in [0, 1], in radius
/// (x) and height (y).
struct ProfilePiece {
    std::array<Vec2, 4> c;
    Vec2 start, end;  // exactly those of the neighbours
    bool straight;
    ProfileLine line{0.0, 0.0, 0.0};  // if straight
    Vec2 low, high;                   // what the piece covers
    double outward = 1.0;             // 1 if (y', -x') points out of the solid, -1 if into it

    Vec2 at(double u) const { return ((c[3] * u + c[2]) * u + c[1]) * u + c[0]; }
    Vec2 tangent(double u) const { return (3.0 * c[3] * u + 2.0 * c[2]) * u + c[1]; }
    /// The parameter of the point nearest to `p`.
    double nearest(const Vec2& p) const;
    /// The unit normal at u, on the outer side.
    Vec2 normal(double u) const;
};

/// The curve that a lathe turns.
class Profile {
public:
    Profile(Spline spline, const std::vector<Vec2>& points);

    const std::vector<ProfilePiece>& pieces() const { return pieces_; }
    /// Whether it bounds a region of the half-plane, alone or together with the axis.
    bool is_closed() const { return closed_; }
    const Vec2& low() const { return low_; }
    const Vec2& high() const { return high_; }
    double size() const { return size_; }

    /// Even-odd: whether an outward line at the point's height crosses the curve an odd number of
    /// times.
    bool contains(const Vec2& p) const;

private:
    /// A stretch of a piece along which the height only rises or only falls.
    struct Stretch {
        std::size_t piece;
        double from, to;      // u
        double y_from, y_to;  // the same where stretches meet
        double least_x, greatest_x;
    };

    void close_chains();
    void add_stretches(std::size_t piece);
    void find_outward_side(ProfilePiece& piece) const;

    std::vector<ProfilePiece> pieces_;
    std::vector<Stretch> stretches_;
    Vec2 low_, high_;
    double size_ = 0.0;
    bool closed_ = false;
};

}  // namespace meniscus::geom
