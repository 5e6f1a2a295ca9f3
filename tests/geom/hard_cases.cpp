#include "tests/geom/hard_cases.hpp"

#include <cmath>

#include "geom/cylindrical.hpp"

namespace meniscus::geom {

namespace {

double sign(Dice& dice) { return dice.below(2) == 0 ? 1.0 : -1.0; }

Vec3 random_direction(Dice& dice) {
    if (dice.below(3) != 0) return dice.direction();
    Vec3 d{0.0};
    d[dice.below(3)] = sign(dice);
    return d;
}

Vec3 random_offset(double size, Dice& dice) {
    const double far[] = {0.0, 0.0, 1.0, 1e3, 1e6};
    return size * far[dice.below(5)] * dice.direction();
}

/// A vase: up its outer wall, down its inner one. The points at the ends only shape the curve,
/// where the spline has such.
std::vector<Vec2> vase(Spline spline, double width, double height, double bottom, Dice& dice) {
    std::vector<Vec2> profile{{0.0, bottom}};
    const int steps = 2 + dice.below(3);
    std::vector<double> radii;
    for (int i = 0; i <= steps; ++i) {
        radii.push_back(width * dice.between(0.5, 1.0));
        profile.push_back({radii.back(), bottom + height * i / steps});
    }
    for (int i = steps; i >= 1; --i) {
        profile.push_back({radii[std::size_t(i)] * dice.between(0.3, 0.95),
                           bottom + height * (i - dice.between(0.0, 0.3)) / steps});
    }
    profile.push_back({0.0, bottom + height * dice.between(0.05, 0.4) / steps});
    if (spline == Spline::linear) return profile;
    if (spline == Spline::bezier) {
        std::vector<Vec2> pieces;
        for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
            const Vec2 p = profile[i], way = profile[i + 1] - p;
            const Vec2 bulge{dice.between(0.0, 0.1) * width, dice.between(-0.1, 0.1) * height};
            pieces.insert(pieces.end(),
                          {p, p + way * 0.33 + bulge, p + way * 0.67 + bulge, profile[i + 1]});
        }
        return pieces;
    }
    profile.insert(profile.begin(), profile.front());
    if (spline == Spline::cubic) profile.push_back(profile.back());
    return profile;
}

}  // namespace

std::string_view name(Kind kind) {
    switch (kind) {
        case Kind::box:
            return "box";
        case Kind::cone:
            return "cone";
        case Kind::cylinder:
            return "cylinder";
        case Kind::plane:
            return "plane";
        case Kind::sphere:
            return "sphere";
        case Kind::torus:
            return "torus";
        case Kind::lathe_linear:
            return "lathe, linear";
        case Kind::lathe_quadratic:
            return "lathe, quadratic";
        case Kind::lathe_cubic:
            return "lathe, cubic";
        case Kind::lathe_bezier:
            return "lathe, bezier";
    }
    return "";
}

std::string_view name(Placement placement) {
    switch (placement) {
        case Placement::as_it_is:
            return "as it is";
        case Placement::moved:
            return "moved";
        case Placement::scaled:
            return "scaled";
        case Placement::sheared:
            return "sheared";
    }
    return "";
}

double log_uniform(double low_decade, double high_decade, Dice& dice) {
    return std::pow(10.0, dice.between(low_decade, high_decade));
}

Shape random_shape(Kind kind, Dice& dice) {
    const double size = log_uniform(-6.0, 6.0, dice);
    const double other =
        size * (dice.below(2) == 0 ? log_uniform(-0.5, 0.5, dice) : log_uniform(-4.0, 0.5, dice));
    const Vec3 offset = random_offset(size, dice);
    const Vec3 cap = offset + size * random_direction(dice);
    const auto lathe = [&](Spline spline) {
        return Lathe(spline, vase(spline, size, other, dice.below(2) * sign(dice) * size, dice));
    };
    switch (kind) {
        case Kind::box: {
            const Vec3 reach{size, other, size * dice.between(0.1, 1.0)};
            return Box{offset - reach, offset + reach};
        }
        case Kind::cone: {
            const double radii[] = {0.0, size * dice.between(0.1, 1.0),
                                    other * (1.0 + log_uniform(-16.0, -1.0, dice)), other};
            if (dice.below(2) == 0) return Cone{offset, other, cap, radii[dice.below(4)]};
            return Cone{offset, radii[dice.below(3)], cap, other};
        }
        case Kind::cylinder:
            return Cylinder{offset, cap, other};
        case Kind::plane:
            return Plane{size * random_direction(dice), dice.below(4) == 0 ? 0.0 : size};
        case Kind::sphere:
            return Sphere{offset, size};
        case Kind::torus:
            return Torus{size, other};
        case Kind::lathe_linear:
            return lathe(Spline::linear);
        case Kind::lathe_quadratic:
            return lathe(Spline::quadratic);
        case Kind::lathe_cubic:
            return lathe(Spline::cubic);
        case Kind::lathe_bezier:
            return lathe(Spline::bezier);
    }
    return Sphere{};
}

Transform random_transform(Placement placement, double size, Dice& dice) {
    const auto turn = [&] { return Transform::rotation_degrees(180.0 * dice.point(1.0)); };
    const auto stretch = [&](double decades) {
        return Transform::scaling({log_uniform(-0.5 * decades, 0.5 * decades, dice),
                                   log_uniform(-0.5 * decades, 0.5 * decades, dice),
                                   sign(dice) * log_uniform(-0.5 * decades, 0.5 * decades, dice)});
    };
    const Transform shift = Transform::translation(random_offset(size, dice));
    switch (placement) {
        case Placement::as_it_is:
            break;
        case Placement::moved:
            return Transform::scaling(Vec3{log_uniform(-1.0, 1.0, dice)}).then(turn()).then(shift);
        case Placement::scaled:
            return stretch(1.0).then(turn()).then(shift);
        case Placement::sheared:
            return turn().then(stretch(1.5)).then(turn()).then(shift);
    }
    return {};
}

Bounds finite_bounds(const Shape& shape) {
    if (const auto* plane = std::get_if<Plane>(&shape)) {
        const Vec3 foot = plane->distance * plane->normal(0, Vec3{0.0});
        return Bounds{foot, foot}.padded(glm::length(plane->direction));
    }
    return bounds(shape);
}

Vec3 random_target(const Bounds& local, const Transform& transform, Dice& dice) {
    Vec3 p;
    for (int i = 0; i < 3; ++i) {
        const double low = local.low[i], high = local.high[i];
        const double special[] = {low, 0.5 * (low + high), high};
        p[i] = dice.below(3) == 0 ? special[dice.below(3)] : dice.between(low, high);
    }
    return transform.point(p);
}

Vec3 direction_at(const Vec3& normal, Dice& dice) {
    const Vec3 any = glm::normalize(glm::cross(normal, dice.direction()));
    const double slope = dice.below(4) == 0 ? 0.0 : sign(dice) * log_uniform(-10.0, 0.0, dice);
    return glm::normalize(any + slope * normal);
}

}  // namespace meniscus::geom
