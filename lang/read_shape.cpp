#include "lang/read_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "lang/read_mesh.hpp"

namespace meniscus::lang {
namespace {

using geom::Vec3;

void read_field(Cursor& cursor, double& value) { value = cursor.number(); }
void read_field(Cursor& cursor, Vec3& value) { value = cursor.vector(); }

template <class Shape>
constexpr bool is_described = std::tuple_size_v<std::remove_cvref_t<decltype(Shape::fields)>> > 0;

template <class Shape>
Shape read_fields(Cursor& cursor) {
    Shape shape;
    std::apply(
        [&](const auto&... field) {
            const auto read = [&](const auto& f) {
                if (f.optional && !cursor.expression()) return;
                read_field(cursor, shape.*(f.member));
            };
            (read(field), ...);
        },
        Shape::fields);
    std::apply(
        [&](const auto&... flag) {
            [[maybe_unused]] const auto read = [&](const auto& f) {
                if (cursor.accept(f.keyword)) shape.*(f.member) = true;
            };
            (read(flag), ...);
        },
        Shape::flags);
    return shape;
}

/// Tries each alternative of the variant.
template <std::size_t... I>
std::optional<geom::Shape> read_any(Cursor& cursor, std::index_sequence<I...>) {
    std::optional<geom::Shape> result;
    const auto attempt = [&]<class Shape>(const Shape*) {
        if constexpr (is_described<Shape>) {
            if (!result && cursor.block_word() == Shape::keyword)
                result = read_fields<Shape>(cursor);
        }
    };
    (attempt(static_cast<const std::variant_alternative_t<I, geom::Shape>*>(nullptr)), ...);
    return result;
}

template <std::size_t... I>
bool is_described_word(std::string_view word, std::index_sequence<I...>) {
    return ((is_described<std::variant_alternative_t<I, geom::Shape>> &&
             word == std::variant_alternative_t<I, geom::Shape>::keyword) ||
            ...);
}

constexpr auto all_shapes = std::make_index_sequence<std::variant_size_v<geom::Shape>>{};

geom::Triangle read_smooth_triangle(Cursor& cursor) {
    geom::Triangle t;
    t.smooth = true;
    t.a = cursor.vector();
    t.na = cursor.vector();
    t.b = cursor.vector();
    t.nb = cursor.vector();
    t.c = cursor.vector();
    t.nc = cursor.vector();
    return t;
}

std::size_t read_count(Cursor& cursor) {
    const auto span = cursor.span();
    const double count = cursor.number();
    if (!(count >= 1.0 && count <= 1e7))
        throw SourceError(span, fmt::format("{} is no number of points", count));
    return static_cast<std::size_t>(count);
}

geom::Polygon read_polygon(Cursor& cursor, const Span& span) {
    const auto count = read_count(cursor);
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < count; ++i) points.push_back(cursor.vector());
    try {
        return geom::Polygon(std::move(points));
    } catch (const std::invalid_argument& error) {
        throw SourceError(span, error.what());
    }
}

geom::Lathe read_lathe(Cursor& cursor, const Span& span) {
    auto spline = geom::Spline::linear;
    if (cursor.accept("linear_spline")) {
    } else if (cursor.accept("quadratic_spline")) {
        spline = geom::Spline::quadratic;
    } else if (cursor.accept("cubic_spline")) {
        spline = geom::Spline::cubic;
    } else if (cursor.accept("bezier_spline")) {
        spline = geom::Spline::bezier;
    }
    const auto count = read_count(cursor);
    std::vector<geom::Vec2> points;
    for (std::size_t i = 0; i < count; ++i) points.push_back(cursor.vector2());
    if (!points.empty() && std::ranges::all_of(points, [](auto& p) { return p.x == 0.0; }))
        throw SourceError(span, "this lathe has no extent: its points lie on the axis");
    try {
        return geom::Lathe(spline, std::move(points));
    } catch (const std::invalid_argument& error) {
        throw SourceError(span, error.what());
    }
}

/// What is wrong with a shape that has no extent where it needs one; a shape may have nothing to
/// say here.
template <class Shape>
std::string_view fault(const Shape&) {
    return "";
}
/// A box without height is a rectangle: a surface, as no ray can be inside it.
std::optional<geom::Polygon> flat_box(const geom::Box& box) {
    const auto a = box.corner1, c = box.corner2;
    Vec3 b = a, d = a;
    if ((a.x == c.x) + (a.y == c.y) + (a.z == c.z) != 1) return std::nullopt;
    const int first = a.x == c.x ? 1 : 0, second = a.z == c.z ? 1 : 2;
    b[first] = c[first];
    d[second] = c[second];
    return geom::Polygon({a, b, c, d, a});
}

std::string_view fault(const geom::Sphere& s) {
    return s.radius == 0.0 ? "this sphere has radius 0" : "";
}
std::string_view fault(const geom::Box& b) {
    const auto size = b.corner1 - b.corner2;
    const int flat = (size.x == 0.0) + (size.y == 0.0) + (size.z == 0.0);
    return flat > 1 ? "this box has no extent: its corners lie on an edge" : "";
}
std::string_view fault(const geom::Cylinder& c) {
    if (c.radius == 0.0) return "this cylinder has radius 0";
    return c.base == c.cap ? "this cylinder has height 0: its two centers are one point" : "";
}
std::string_view fault(const geom::Cone& c) {
    if (c.base == c.cap) return "this cone has height 0: its two centers are one point";
    return c.base_radius == 0.0 && c.cap_radius == 0.0 ? "this cone has radius 0 at both ends" : "";
}
std::string_view fault(const geom::Torus& t) {
    if (t.minor == 0.0) return "this torus has minor radius 0";
    return t.major < 0.0 || t.minor < 0.0 ? "a torus needs radii that are not negative" : "";
}
std::string_view fault(const geom::Plane& p) {
    return p.direction == Vec3{0.0} ? "this plane has no direction: its normal is zero" : "";
}
std::string_view fault(const geom::Disc& d) {
    if (d.direction == Vec3{0.0}) return "this disc has no direction: its normal is zero";
    return !(d.radius > d.hole_radius) || d.radius <= 0.0 ? "this disc has no area" : "";
}
std::string_view fault(const geom::Triangle& t) {
    return glm::cross(t.b - t.a, t.c - t.a) == Vec3{0.0}
               ? "this triangle has no area: its corners lie on a line"
               : "";
}

}  // namespace

bool is_shape_word(std::string_view word) {
    return is_described_word(word, all_shapes) || word == "smooth_triangle" || word == "polygon" ||
           word == "lathe" || word == "mesh" || word == "mesh2";
}

std::optional<geom::Shape> read_shape(Cursor& cursor) {
    const auto span = cursor.span();
    const auto word = cursor.block_word();
    if (word == "smooth_triangle") return read_smooth_triangle(cursor);
    if (word == "polygon") return read_polygon(cursor, span);
    if (word == "lathe") return read_lathe(cursor, span);
    if (word == "mesh2") return read_mesh2(cursor, span);
    auto shape = read_any(cursor, all_shapes);
    if (const auto* box = shape ? std::get_if<geom::Box>(&*shape) : nullptr) {
        if (auto flat = flat_box(*box)) return *flat;
    }
    return shape;
}

void check_shape(const geom::Shape& shape, const Span& span) {
    const auto text = std::visit([](const auto& s) { return fault(s); }, shape);
    if (!text.empty()) throw SourceError(span, std::string(text));
}

}  // namespace meniscus::lang
