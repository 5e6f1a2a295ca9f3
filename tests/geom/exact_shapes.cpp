#include <stdexcept>

#include "tests/geom/referee.hpp"

namespace meniscus::geom {

namespace {

using oracle::square_root;
using oracle::widen;
using Meetings = std::vector<ExactShape::Meeting>;

/// a t^2 + 2 b t + c = 0
void meet_quadratic(Quad a, Quad b, Quad c, Face face, Meetings& out) {
    const Quad discriminant = b * b - a * c;
    if (discriminant < 0) return;
    const Quad root = square_root(discriminant), q = b < 0 ? -b + root : -b - root;
    if (a != 0) out.push_back({q / a, face});
    if (q != 0) out.push_back({c / q, face});
}

/// n.(o + t d) = distance
void meet_plane(const QuadVec& n, Quad distance, const QuadVec& o, const QuadVec& d, Face face,
                Meetings& out) {
    const Quad rate = dot(n, d);
    if (rate != 0) out.push_back({(distance - dot(n, o)) / rate, face});
}

class ExactSphere : public ExactShape {
public:
    explicit ExactSphere(const Sphere& s) : center_(widen<Quad>(s.center)), radius_(s.radius) {}

    void meet(const QuadVec& o, const QuadVec& d, Meetings& out) const override {
        const QuadVec e = o - center_;
        meet_quadratic(dot(d, d), dot(e, d), dot(e, e) - radius_ * radius_, 0, out);
    }
    bool contains(const QuadVec& p) const override {
        return dot(p - center_, p - center_) < radius_ * radius_;
    }
    QuadVec gradient(Face, const QuadVec& p) const override { return p - center_; }

private:
    QuadVec center_;
    Quad radius_;
};

class ExactPlane : public ExactShape {
public:
    explicit ExactPlane(const Plane& s)
        : normal_(unit(widen<Quad>(s.direction))), distance_(s.distance) {}

    void meet(const QuadVec& o, const QuadVec& d, Meetings& out) const override {
        meet_plane(normal_, distance_, o, d, 0, out);
    }
    bool contains(const QuadVec& p) const override { return dot(normal_, p) < distance_; }
    QuadVec gradient(Face, const QuadVec&) const override { return normal_; }

private:
    QuadVec normal_;
    Quad distance_;
};

class ExactBox : public ExactShape {
public:
    explicit ExactBox(const Box& s) : low_(widen<Quad>(s.low())), high_(widen<Quad>(s.high())) {}

    void meet(const QuadVec& o, const QuadVec& d, Meetings& out) const override {
        for (Face face = 0; face < 6; ++face) {
            const QuadVec n = gradient(face, o);
            meet_plane(n, dot(n, face % 2 == 0 ? low_ : high_), o, d, face, out);
        }
    }
    bool contains(const QuadVec& p) const override {
        return low_.x < p.x && p.x < high_.x && low_.y < p.y && p.y < high_.y && low_.z < p.z &&
               p.z < high_.z;
    }
    QuadVec gradient(Face face, const QuadVec&) const override {
        const auto component = [&](int axis) { return Quad(face / 2 == axis ? 1 : 0); };
        return {component(0), component(1), component(2)};
    }

private:
    QuadVec low_, high_;
};

/// Cones, and cylinders as cones of equal radii.
class ExactCone : public ExactShape {
public:
    ExactCone(const Vec3& base, double base_radius, const Vec3& cap, double cap_radius)
        : base_(widen<Quad>(base)),
          axis_(widen<Quad>(cap) - base_),
          whole_(dot(axis_, axis_)),
          radius_(base_radius),
          growth_(Quad(cap_radius) - Quad(base_radius)) {}

    void meet(const QuadVec& o, const QuadVec& d, Meetings& out) const override {
        const QuadVec e = o - base_;
        const Quad at = dot(e, axis_) / whole_, rate = dot(d, axis_) / whole_;
        const QuadVec ep = e - at * axis_, dp = d - rate * axis_;
        const Quad width = radius_ + growth_ * at, widening = growth_ * rate;
        meet_quadratic(dot(dp, dp) - widening * widening, dot(ep, dp) - width * widening,
                       dot(ep, ep) - width * width, Cone::side_face, out);
        meet_plane(axis_, Quad(0), e, d, Cone::base_face, out);
        meet_plane(axis_, whole_, e, d, Cone::cap_face, out);
    }
    bool contains(const QuadVec& p) const override {
        const QuadVec e = p - base_;
        const Quad along = dot(e, axis_) / whole_;
        const QuadVec away = e - along * axis_;
        const Quad width = radius_ + growth_ * along;
        return 0 < along && along < 1 && dot(away, away) < width * width;
    }
    QuadVec gradient(Face face, const QuadVec& p) const override {
        if (face != Cone::side_face) return axis_;
        const QuadVec e = p - base_;
        const Quad along = dot(e, axis_) / whole_;
        const QuadVec away = e - along * axis_;
        const Quad distance = square_root(dot(away, away));
        return away - (distance * growth_ / whole_) * axis_;
    }

private:
    QuadVec base_, axis_;
    Quad whole_, radius_, growth_;
};

class ExactTorus : public ExactShape {
public:
    explicit ExactTorus(const Torus& s) : major_(s.major), minor_(s.minor) {}

    void meet(const QuadVec& o, const QuadVec& d, Meetings& out) const override {
        const Quad dd = dot(d, d), nearest = -dot(o, d) / dd, reach = major_ + minor_;
        const QuadVec p = o + nearest * d;
        const Quad pp = dot(p, p);
        if (pp > reach * reach) return;
        // (|p + t d|^2 + R^2 - r^2)^2 = 4 R^2 (|p + t d|^2 - (p + t d).y^2), and p.d = 0
        const Quad k = pp + major_ * major_ - minor_ * minor_, four = 4 * major_ * major_;
        const std::vector<Quad> quartic{k * k - four * (pp - p.y * p.y), four * 2 * p.y * d.y,
                                        2 * k * dd - four * (dd - d.y * d.y), Quad(0), dd * dd};
        const Quad half = square_root(Quad(reach * reach / dd)) * 2;
        for (const Quad t : sign_changes(quartic, -half, half)) out.push_back({nearest + t, 0});
        if (d.y != 0 && minor_ > major_) {  // on the axis the quartic only touches 0
            const Quad height = square_root(Quad(minor_ * minor_ - major_ * major_));
            out.push_back({(height - o.y) / d.y, 0});
            out.push_back({(-height - o.y) / d.y, 0});
        }
    }
    bool contains(const QuadVec& p) const override {
        const Quad ring = square_root(p.x * p.x + p.z * p.z) - major_;
        return ring * ring + p.y * p.y < minor_ * minor_;
    }
    QuadVec gradient(Face, const QuadVec& p) const override {
        const Quad ring = square_root(p.x * p.x + p.z * p.z);
        const Quad scale = ring > 0 ? Quad(1 - major_ / ring) : Quad(1);
        return {p.x * scale, p.y, p.z * scale};
    }

private:
    Quad major_, minor_;
};

}  // namespace

std::unique_ptr<ExactShape> exact_shape(const Shape& shape) {
    return std::visit(
        []<class T>(const T& s) -> std::unique_ptr<ExactShape> {
            if constexpr (std::is_same_v<T, Sphere>) return std::make_unique<ExactSphere>(s);
            if constexpr (std::is_same_v<T, Plane>) return std::make_unique<ExactPlane>(s);
            if constexpr (std::is_same_v<T, Box>) return std::make_unique<ExactBox>(s);
            if constexpr (std::is_same_v<T, Torus>) return std::make_unique<ExactTorus>(s);
            if constexpr (std::is_same_v<T, Lathe>) return exact_lathe(s);
            if constexpr (std::is_same_v<T, Cylinder>)
                return std::make_unique<ExactCone>(s.base, s.radius, s.cap, s.radius);
            if constexpr (std::is_same_v<T, Cone>)
                return std::make_unique<ExactCone>(s.base, s.base_radius, s.cap, s.cap_radius);
            throw std::invalid_argument("the referee does not know this shape");
        },
        shape);
}

}  // namespace meniscus::geom
