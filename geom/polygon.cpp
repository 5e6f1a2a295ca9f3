#include "geom/polygon.hpp"

#include <stdexcept>
#include <utility>

#include "geom/cylindrical.hpp"

namespace meniscus::geom {

Polygon::Polygon() : Polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}}) {}

Polygon::Polygon(std::vector<Vec3> points) : points_(std::move(points)) {
    if (points_.size() < 3) throw std::invalid_argument("a polygon needs at least three points");
    // A loop ends where its first point returns; the last one is closed if the points do not.
    std::size_t start = 0;
    loop_starts_.push_back(0);
    for (std::size_t i = 1; i < points_.size(); ++i) {
        if (i > start + 1 && points_[i] == points_[start]) {
            loop_starts_.push_back(start = i + 1);
            ++i;
        }
    }
    if (start < points_.size()) {
        points_.push_back(points_[start]);
        loop_starts_.push_back(points_.size());
    }

    // Newell's normal of the largest loop: twice its area long.
    for (const Vec3& p : points_) bounds_.extend(p);
    for (std::size_t loop = 0; loop + 1 < loop_starts_.size(); ++loop) {
        Vec3 sum{0.0};
        for (std::size_t i = loop_starts_[loop]; i + 1 < loop_starts_[loop + 1]; ++i) {
            sum += glm::cross(points_[i] - points_[0], points_[i + 1] - points_[0]);
        }
        if (glm::dot(sum, sum) > glm::dot(normal_, normal_)) normal_ = sum;
    }
    const double size = max_abs(bounds_.size());
    if (!(glm::length(normal_) > 1e-12 * size * size)) {
        throw std::invalid_argument("the points of a polygon lie on one line");
    }
    normal_ = glm::normalize(normal_);
    for (const Vec3& p : points_) {
        if (glm::abs(glm::dot(p - points_[0], normal_)) > 1e-6 * size) {
            throw std::invalid_argument("the points of a polygon do not lie in one plane");
        }
    }
    const Vec3 slope = glm::abs(normal_);
    axis_ = slope.x > slope.y ? (slope.x > slope.z ? 0 : 2) : (slope.y > slope.z ? 1 : 2);
}

double Polygon::magnitude() const { return glm::max(max_abs(bounds_.low), max_abs(bounds_.high)); }

bool Polygon::covers(const Vec3& p) const {
    const int x = (axis_ + 1) % 3, y = (axis_ + 2) % 3;
    bool inside = false;
    for (std::size_t loop = 0; loop + 1 < loop_starts_.size(); ++loop) {
        for (std::size_t i = loop_starts_[loop]; i + 1 < loop_starts_[loop + 1]; ++i) {
            // From the lower end to the upper, so that polygons on either side of an edge agree.
            const bool upwards = points_[i][y] <= points_[i + 1][y];
            const Vec3& a = points_[upwards ? i : i + 1];
            const Vec3& b = points_[upwards ? i + 1 : i];
            if ((a[y] <= p[y]) == (b[y] <= p[y])) continue;
            const double side = (b[x] - a[x]) * (p[y] - a[y]) - (p[x] - a[x]) * (b[y] - a[y]);
            if (side > 0.0) inside = !inside;
        }
    }
    return inside;
}

void Polygon::hits(const Ray& ray, Crossings& out) const {
    const double slope = glm::dot(ray.direction, normal_);
    if (slope == 0.0) return;
    const double t = -glm::dot(ray.from(points_[0]), normal_) / slope;
    if (covers(ray.at(t))) out.push_back({t, 0, slope < 0.0});
}

Vec3 Polygon::normal(Face, const Vec3&) const { return normal_; }

Vec3 Polygon::to_face(Face, const Ray& point) const {
    return to_plane(point.from(points_[0]), normal_);
}

}  // namespace meniscus::geom
