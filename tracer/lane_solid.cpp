#include "tracer/lane_solid.hpp"

#include <algorithm>
#include <optional>

#include "geom/cylindrical.hpp"
#include "geom/profile.hpp"

namespace meniscus::tracer {
namespace {

lanes::Solid convert(const geom::Sphere& sphere) {
    lanes::Solid solid;
    solid.kind = lanes::Kind::sphere;
    solid.center = sphere.center;
    solid.radius = sphere.radius;
    solid.inverse_radius = 1.0 / sphere.radius;
    return solid;
}

lanes::Solid convert(const geom::Box& box) {
    lanes::Solid solid;
    solid.kind = lanes::Kind::box;
    solid.low = box.low();
    solid.high = box.high();
    return solid;
}

lanes::Solid convert(const geom::Cylinder& cylinder) {
    lanes::Solid solid;
    solid.kind = lanes::Kind::cylinder;
    const geom::Axis axis(cylinder.base, cylinder.cap);
    solid.center = cylinder.base;
    solid.axis = axis.direction;
    solid.length = axis.length;
    solid.radius = cylinder.radius;
    return solid;
}

lanes::Solid convert(const geom::Plane& plane) {
    lanes::Solid solid;
    solid.kind = lanes::Kind::half_space;
    solid.center = plane.normal(0, geom::Vec3{0.0});
    solid.distance = plane.distance;
    return solid;
}

lanes::Solid foreign(const geom::Shape& shape, bool is_convex) {
    lanes::Solid solid;
    solid.kind = std::holds_alternative<geom::Mesh>(shape) ? lanes::Kind::mesh
                 : is_convex                               ? lanes::Kind::other_convex
                                                           : lanes::Kind::other;
    return solid;
}

/// Whether a lathe's pieces make a cup, in whatever order; those along the axis bound nothing.
std::optional<lanes::Cup> find_cup(const std::vector<lanes::Piece>& pieces) {
    int base = -1, outer = -1, top = -1, inner = -1, floor = -1, count = 0;
    for (int i = 0; i < int(pieces.size()); ++i) {
        const lanes::Piece& piece = pieces[std::size_t(i)];
        if (piece.high_radius == 0.0) continue;
        ++count;
        const bool is_ring = piece.a == 0.0, is_whole = piece.low_radius == 0.0;
        if (!is_ring && piece.b != 0.0) return std::nullopt;
        int& which = !is_ring        ? (piece.a > 0.0 ? outer : inner)
                     : piece.b < 0.0 ? base
                     : is_whole      ? floor
                                     : top;
        which = i;
    }
    if (count != 5 || std::min({base, outer, top, inner, floor}) < 0) return std::nullopt;
    const auto at = [&](int i) -> const lanes::Piece& { return pieces[std::size_t(i)]; };
    lanes::Cup cup{at(outer).high_radius,
                   at(inner).high_radius,
                   at(base).low_height,
                   at(floor).low_height,
                   at(top).low_height,
                   base,
                   outer,
                   top,
                   inner,
                   floor};
    const bool fits =
        at(base).low_radius == 0.0 && at(base).high_radius == cup.outer_radius &&
        at(top).low_radius == cup.inner_radius && at(top).high_radius == cup.outer_radius &&
        at(floor).high_radius == cup.inner_radius && at(outer).low_height == cup.base &&
        at(outer).high_height == cup.top && at(inner).low_height == cup.floor &&
        at(inner).high_height == cup.top && cup.base < cup.floor && cup.floor < cup.top &&
        cup.inner_radius < cup.outer_radius;
    return fits ? std::optional(cup) : std::nullopt;
}

lanes::Solid convert(const geom::Lathe& lathe) {
    lanes::Solid solid;
    solid.kind = lanes::Kind::lathe;
    const geom::Profile& profile = lathe.profile();
    solid.height = 0.5 * (profile.low().y + profile.high().y);
    solid.size = profile.size();
    for (const geom::ProfilePiece& piece : profile.pieces()) {
        solid.pieces.push_back({piece.line.a * piece.outward, piece.line.b * piece.outward,
                                piece.line.c * piece.outward, piece.low.x, piece.high.x,
                                piece.low.y, piece.high.y});
    }
    if (const auto cup = find_cup(solid.pieces)) {
        solid.is_cup = true;
        solid.cup = *cup;
    }
    solid.is_stepped = std::ranges::all_of(
        solid.pieces, [](const auto& piece) { return piece.a == 0.0 || piece.b == 0.0; });
    return solid;
}

/// Whether lanes have code for a shape of their own.
bool is_native(const geom::Shape& shape) {
    if (const auto* lathe = std::get_if<geom::Lathe>(&shape)) {
        const auto& pieces = lathe->profile().pieces();
        return pieces.size() <= std::size_t(lanes::most_pieces) &&
               std::ranges::all_of(pieces, [](const auto& piece) { return piece.straight; });
    }
    return std::holds_alternative<geom::Sphere>(shape) ||
           std::holds_alternative<geom::Box>(shape) ||
           std::holds_alternative<geom::Cylinder>(shape) ||
           std::holds_alternative<geom::Plane>(shape);
}

template <class Other>
lanes::Solid convert(const Other&) {
    return {};  // not native
}

}  // namespace

double sphere_around(const geom::Bounds& bounds, const geom::Vec3& middle) {
    return 0.5 * glm::length(bounds.size()) * (1.0 + 1e-6) + 1e-9 * geom::max_abs(middle);
}

lanes::Solid make_lane_solid(const Part& part, int index) {
    const geom::Shape& shape = part.shape.shape();
    lanes::Solid solid = is_native(shape)
                             ? std::visit([](const auto& s) { return convert(s); }, shape)
                             : foreign(shape, part.shape.is_convex());
    solid.part = index;
    solid.inverse = part.inverse;
    solid.to_camera = !part.no_image;
    solid.to_mirrors = !part.no_reflection;
    solid.to_lights = !part.no_shadow || part.is_member;
    solid.placed = !part.shape.transform().is_identity();
    solid.transform = part.shape.transform();
    solid.magnitude = part.shape.magnitude();
    if (lanes::is_costly(solid.kind)) {
        const geom::Bounds bounds = part.shape.bounds();
        solid.middle = 0.5 * (bounds.low + bounds.high);
        solid.reach = sphere_around(bounds, solid.middle);
    }
    if (const auto* mesh = std::get_if<geom::Mesh>(&shape)) {
        const geom::Bounds box = mesh->bounds();
        const geom::Bounds wider =
            box.padded(1e-6 * (mesh->magnitude() + geom::max_abs(box.size())));
        solid.low = wider.low;
        solid.high = wider.high;
    }
    return solid;
}

}  // namespace meniscus::tracer
