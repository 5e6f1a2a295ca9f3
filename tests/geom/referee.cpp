#include "tests/geom/referee.hpp"

#include <algorithm>

namespace meniscus::geom {

using oracle::absolute;
using oracle::square_root;
using oracle::widen;

Referee::Referee(const Shape& shape, const Transform& transform) : shape_(exact_shape(shape)) {
    const auto& m = transform.linear();  // m[column][row]
    const QuadVec a = widen<Quad>(m[0]), b = widen<Quad>(m[1]), c = widen<Quad>(m[2]);
    const Quad determinant = dot(a, cross(b, c));
    rows_[0] = (Quad(1) / determinant) * cross(b, c);
    rows_[1] = (Quad(1) / determinant) * cross(c, a);
    rows_[2] = (Quad(1) / determinant) * cross(a, b);
    shift_ = widen<Quad>(transform.shift());
}

QuadVec Referee::origin(const Ray& ray) {
    return widen<Quad>(ray.origin) + widen<Quad>(ray.origin_error);
}

QuadVec Referee::at(const Ray& ray, Quad t) { return origin(ray) + t * widen<Quad>(ray.direction); }

QuadVec Referee::to_local_vector(const QuadVec& v) const {
    return {dot(rows_[0], v), dot(rows_[1], v), dot(rows_[2], v)};
}

std::vector<Referee::Crossing> Referee::crossings(const Ray& ray) const {
    const QuadVec o = to_local(origin(ray)), d = to_local_vector(widen<Quad>(ray.direction));
    std::vector<ExactShape::Meeting> meetings;
    shape_->meet(o, d, meetings);
    std::sort(meetings.begin(), meetings.end(), [](auto& a, auto& b) { return a.t < b.t; });
    std::vector<Crossing> result;
    bool inside = meetings.empty() || shape_->contains(o + (meetings[0].t - Quad(1)) * d);
    for (std::size_t i = 0; i < meetings.size(); ++i) {
        const Quad t = meetings[i].t;
        const Quad behind = i + 1 < meetings.size() ? (t + meetings[i + 1].t) / 2 : t + 1;
        const bool inside_behind = shape_->contains(o + behind * d);
        if (inside_behind != inside) result.push_back({t, meetings[i].face});
        inside = inside_behind;
    }
    return result;
}

QuadVec Referee::normal(const Ray& ray, Face face, Quad t) const {
    const QuadVec n = shape_->gradient(face, to_local(at(ray, t)));
    const QuadVec world = n.x * rows_[0] + n.y * rows_[1] + n.z * rows_[2];
    const Quad length = square_root(dot(world, world));
    return length > 0 ? (Quad(1) / length) * world : QuadVec{0, 1, 0};
}

double Referee::cosine(const Ray& ray, Face face, Quad t) const {
    return double(absolute(Quad(dot(normal(ray, face, t), widen<Quad>(ray.direction)))));
}

}  // namespace meniscus::geom
