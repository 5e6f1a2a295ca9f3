#pragma once

#include <array>
#include <vector>

#include "geom/lathe.hpp"
#include "geom/profile_arc.hpp"
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

    /// The largest coordinate.
    double magnitude() const { return glm::max(high_.x, glm::max(-low_.y, high_.y)); }

    /// The pieces cut up, in order, with a gap between chains.
    const std::vector<ProfileArc>& arcs() const { return arcs_; }

    /// Even-odd: whether an outward line at the point's height crosses the curve an odd number of
    /// times.
    bool contains(const Vec2& p) const;

    /// The outward unit normal of a piece next to a point, and how far the point lies out there.
    struct Foot {
        Vec2 normal;
        double distance;
    };
    Foot foot(Face piece, const Vec2& p) const;

private:
    void close_chains();
    void cut_into_arcs();
    void find_outward_side(ProfilePiece& piece) const;

    std::vector<ProfilePiece> pieces_;
    std::vector<ProfileArc> arcs_;
    std::vector<std::size_t> first_arc_;  // of each piece, and the end of the last
    Vec2 low_, high_;
    double size_ = 0.0;
    bool closed_ = false;
};

}  // namespace meniscus::geom
