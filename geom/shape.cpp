#include "geom/shape.hpp"

#include <cassert>

namespace meniscus::geom {

std::string_view keyword(const Shape& shape) {
    return std::visit([](const auto& s) -> std::string_view { return s.keyword; }, shape);
}

bool is_closed(const Shape& shape) {
    return std::visit([](const auto& s) { return s.is_closed(); }, shape);
}

bool is_convex(const Shape& shape) {
    return std::visit(
        []<class T>(const T& s) {
            if constexpr (Convex<T>) return s.is_closed();
            return false;
        },
        shape);
}

Bounds bounds(const Shape& shape) {
    return std::visit([](const auto& s) { return s.bounds(); }, shape);
}

double magnitude(const Shape& shape) {
    return std::visit([](const auto& s) { return s.magnitude(); }, shape);
}

Interval interval(const Shape& shape, const Ray& ray, Face pin) {
    return std::visit(
        [&]<class T>(const T& s) {
            if constexpr (Convex<T>) return s.interval(ray, pin);
            assert(!"only convex solids have intervals");
            return Interval{};
        },
        shape);
}

void crossings(const Shape& shape, const Ray& ray, Crossings& out) {
    std::visit(
        [&]<class T>(const T& s) {
            if constexpr (Convex<T>) {
                const Interval span = s.interval(ray, no_face);
                if (!span.hit) return;
                if (span.t0 > -infinity) out.push_back({span.t0, span.face0, true});
                if (span.t1 < infinity) out.push_back({span.t1, span.face1, false});
            } else if constexpr (Solid<T>) {
                s.crossings(ray, out);
            }
        },
        shape);
}

void hits(const Shape& shape, const Ray& ray, Crossings& out) {
    std::visit(
        [&]<class T>(const T& s) {
            if constexpr (Surface<T>) s.hits(ray, out);
        },
        shape);
}

void crossings(const Shape& shape, const Ray& ray, const Search& search, Crossings& out) {
    if (const auto* mesh = std::get_if<Mesh>(&shape)) return mesh->crossings(ray, search, out);
    is_closed(shape) ? crossings(shape, ray, out) : hits(shape, ray, out);
}

bool crossings_ahead(const Shape& shape, const Ray& ray, const Search& search,
                     std::optional<int> depth, Crossings& out) {
    const auto* mesh = std::get_if<Mesh>(&shape);
    return mesh && mesh->crossings_ahead(ray, search, depth, out);
}

Vec3 normal(const Shape& shape, Face face, const Ray& point) {
    return std::visit(
        [&](const auto& s) {
            if constexpr (requires { s.normal(face, point); }) {
                return s.normal(face, point);
            } else {
                return s.normal(face, point.at(0.0));
            }
        },
        shape);
}

Vec3 shading_normal(const Shape& shape, Face face, const Ray& point) {
    return std::visit(
        [&](const auto& s) {
            if constexpr (requires { s.shading_normal(face, point.origin); }) {
                return s.shading_normal(face, point.at(0.0));
            } else {
                return normal(shape, face, point);
            }
        },
        shape);
}

Vec3 to_face(const Shape& shape, Face face, const Ray& point) {
    return std::visit([&](const auto& s) { return s.to_face(face, point); }, shape);
}

Vec3 on_face(const Shape& shape, Face face, const Vec3& p) {
    return p + to_face(shape, face, Ray{p});
}

bool contains(const Shape& shape, const Vec3& p) {
    return std::visit(
        [&](const auto& s) {
            if constexpr (requires { s.contains(p); }) {
                return s.is_closed() && s.contains(p);
            } else {
                return false;
            }
        },
        shape);
}

int depth_at(const Shape& shape, const Vec3& p) {
    return std::visit(
        [&](const auto& s) {
            if constexpr (requires { s.depth_at(p); }) {
                return s.is_closed() ? s.depth_at(p) : 0;
            } else if constexpr (requires { s.contains(p); }) {
                return s.is_closed() && s.contains(p) ? 1 : 0;
            } else {
                return 0;
            }
        },
        shape);
}

}  // namespace meniscus::geom
