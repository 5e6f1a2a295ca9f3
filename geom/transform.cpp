#include "geom/transform.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace meniscus::geom {

namespace {

struct Angle {
    double sine, cosine;
};

/// Quarter turns are exact: a box turned by 90 degrees still has its faces along the axes.
Angle angle_of(double degrees) {
    const double turn = std::remainder(degrees, 360.0);
    if (turn == 0.0) return {0.0, 1.0};
    if (turn == 90.0) return {1.0, 0.0};
    if (turn == -90.0) return {-1.0, 0.0};
    if (std::fabs(turn) == 180.0) return {0.0, -1.0};
    const double radians = turn * (std::numbers::pi / 180.0);
    return {std::sin(radians), std::cos(radians)};
}

bool is_diagonal(const Mat3& m) {
    return m[0][1] == 0.0 && m[0][2] == 0.0 && m[1][0] == 0.0 && m[1][2] == 0.0 && m[2][0] == 0.0 &&
           m[2][1] == 0.0;
}

Mat3 inverse_of(const Mat3& m) {
    if (is_diagonal(m)) {
        const Vec3 d{m[0][0], m[1][1], m[2][2]};
        if (d.x == 0.0 || d.y == 0.0 || d.z == 0.0) {
            throw std::invalid_argument("a transformation flattens space: a scale is 0");
        }
        Mat3 result{1.0};
        for (int i = 0; i < 3; ++i) result[i][i] = 1.0 / d[i];
        return result;
    }
    const Vec3 r0 = glm::cross(m[1], m[2]), r1 = glm::cross(m[2], m[0]),
               r2 = glm::cross(m[0], m[1]);
    const double determinant = glm::dot(m[0], r0);
    const double size = glm::length(m[0]) * glm::length(m[1]) * glm::length(m[2]);
    if (!(std::fabs(determinant) > 1e-14 * size) || !std::isfinite(determinant)) {
        throw std::invalid_argument("a transformation flattens space: its matrix has no inverse");
    }
    return glm::transpose(Mat3{r0 / determinant, r1 / determinant, r2 / determinant});
}

/// The square root of the largest eigenvalue of m^T m, by powers; a diagonal's is its largest
/// entry, exactly.
double norm(const Mat3& m) {
    if (is_diagonal(m)) return max_abs({m[0][0], m[1][1], m[2][2]});
    // Squaring six times leaves the largest eigenvalue to the 64th power; the trace is at most
    // three times that.
    Mat3 power = glm::transpose(m) * m;
    double log_scale = 0.0, weight = 1.0;
    for (int i = 0; i < 6; ++i) {
        const double trace = power[0][0] + power[1][1] + power[2][2];
        log_scale += weight * std::log(trace);
        power = (power / trace) * (power / trace);
        weight *= 0.5;
    }
    log_scale += weight * std::log(power[0][0] + power[1][1] + power[2][2]);
    return std::exp(0.5 * log_scale);
}

}  // namespace

const Transform::Numbers Transform::identity;

Transform::Transform(const Mat3& linear, const Vec3& shift) {
    const bool is_translation = linear == Mat3{1.0};
    if (is_translation && shift == Vec3{0.0}) return;
    numbers_ = std::make_shared<const Numbers>(
        Numbers{linear, inverse_of(linear), shift, norm(linear), is_translation});
}

Transform Transform::translation(const Vec3& shift) { return {Mat3{1.0}, shift}; }

Transform Transform::scaling(const Vec3& factors) {
    Mat3 linear{1.0};
    for (int i = 0; i < 3; ++i) linear[i][i] = factors[i];
    return {linear, Vec3{0.0}};
}

Transform Transform::rotation_degrees(const Vec3& angles) {
    Mat3 linear{1.0};
    for (int axis = 0; axis < 3; ++axis) {
        const auto [sine, cosine] = angle_of(angles[axis]);
        const int from = (axis + 1) % 3, to = (axis + 2) % 3;
        Mat3 turn{1.0};  // takes the axis `from` towards `to`
        turn[from][from] = cosine;
        turn[from][to] = sine;
        turn[to][from] = -sine;
        turn[to][to] = cosine;
        linear = turn * linear;
    }
    return {linear, Vec3{0.0}};
}

Transform Transform::then(const Transform& next) const {
    if (is_identity()) return next;
    if (next.is_identity()) return *this;
    return {next.linear() * linear(), next.point(shift())};
}

Transform Transform::inverse() const {
    if (is_identity()) return *this;
    return {inverse_linear(), -(inverse_linear() * shift())};
}

Ray Transform::to_local(const Ray& ray) const {
    if (is_identity()) return ray;
    const Vec3& shift = numbers_->shift;
    if (numbers_->is_translation) {
        // What the subtraction loses goes to the error (Knuth's two-sum).
        const Vec3 sum = ray.origin - shift;
        const Vec3 part = sum - ray.origin;
        const Vec3 lost = (ray.origin - (sum - part)) - (shift + part);
        return {sum, ray.direction, ray.origin_error + lost};
    }
    const Mat3& inverse = numbers_->inverse_linear;
    return {inverse * ray.from(shift), inverse * ray.direction, Vec3{0.0}};
}

Bounds Transform::bounds(const Bounds& local) const {
    if (is_identity() || local.is_empty()) return local;
    if (!local.is_finite()) return Bounds::everything();
    Bounds result;
    for (int corner = 0; corner < 8; ++corner) {
        result.extend(
            point({corner & 1 ? local.high.x : local.low.x, corner & 2 ? local.high.y : local.low.y,
                   corner & 4 ? local.high.z : local.low.z}));
    }
    return result;
}

}  // namespace meniscus::geom
