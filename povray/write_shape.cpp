#include "povray/write_shape.hpp"

#include <cmath>
#include <map>
#include <vector>

#include "povray/write_lathe.hpp"
#include "povray/write_mesh.hpp"

namespace meniscus::povray {
namespace {

using namespace geom;

/// A shape of a few words: its block is opened with them.
std::string head(const Sphere& s) {
    return fmt::format("{}, {}", place(s.center), length(s.radius));
}
std::string head(const Box& s) { return fmt::format("{}, {}", place(s.low()), place(s.high())); }
std::string head(const Cylinder& s) {
    return fmt::format("{}, {}, {}{}", place(s.base), place(s.cap), length(s.radius),
                       s.open ? " open" : "");
}
std::string head(const Cone& s) {
    return fmt::format("{}, {}, {}, {}{}", place(s.base), length(s.base_radius), place(s.cap),
                       length(s.cap_radius), s.open ? " open" : "");
}
/// POV-Ray's other way to the roots, its default, is coarse enough to be seen.
std::string head(const Torus& s) {
    return fmt::format("{}, {} sturm", length(s.major), length(s.minor));
}
std::string head(const Plane& s) {
    return fmt::format("{}, {}", vector(s.direction), length(s.distance));
}
std::string head(const Disc& s) {
    return fmt::format("{}, {}, {}, {}", place(s.center), vector(s.direction), length(s.radius),
                       length(s.hole_radius));
}
std::string head(const Triangle& s) {
    if (!s.smooth) return fmt::format("{}, {}, {}", place(s.a), place(s.b), place(s.c));
    return fmt::format("{}, {}, {}, {}, {}, {}", place(s.a), vector(s.na), place(s.b), vector(s.nb),
                       place(s.c), vector(s.nc));
}

std::string joined(const auto& points, std::size_t a_line) {
    std::string text;
    for (std::size_t i = 0; i < points.size(); ++i) {
        text += place(points[i]);
        if (i + 1 < points.size()) text += (i + 1) % a_line == 0 ? ",\n        " : ", ";
    }
    return text;
}

std::string head(const Polygon& s) {
    return fmt::format("{},\n        {}", s.points().size(), joined(s.points(), 4));
}

std::string head(const Lathe& s) { return lathe_head(s); }

/// A torus that closes over its hole: POV-Ray also has the sheet within, where the ring reaches
/// over the axis. The ball over that sheet lies in the ring and touches its skin at the two tips
/// alone.
bool write_closed_torus(Writer& writer, const Shape& shape, const std::vector<std::string>& lines) {
    const auto* torus = std::get_if<Torus>(&shape);
    if (!torus || torus->minor <= torus->major) return false;
    const double radius = std::sqrt((torus->minor - torus->major) * (torus->minor + torus->major));
    writer.open("merge");
    writer.line("torus {{ {} }}", head(*torus));
    writer.line("sphere {{ <0, 0, 0>, {} }}  // takes away the sheet within", length(radius));
    for (const auto& line : lines) writer.line("{}", line);
    writer.close();
    return true;
}

std::string_view word(const Shape& shape) {
    const auto* triangle = std::get_if<Triangle>(&shape);
    return triangle && triangle->smooth ? "smooth_triangle" : keyword(shape);
}

}  // namespace

std::string transformation(const Transform& transform) {
    if (transform.is_identity()) return {};
    if (transform.is_translation()) return "translate " + place(transform.shift());
    const Mat3& m = transform.linear();
    const Vec3& t = transform.shift();
    std::string text = "matrix <";
    for (int i = 0; i < 3; ++i)
        text += fmt::format("{}, {}, {}, ", number(m[i].x), number(m[i].y), number(m[i].z));
    return text + fmt::format("{}, {}, {}>", length(t.x), length(t.y), length(t.z));
}

void write_shape(Writer& writer, const scene::Object& object, std::span<const std::string> words) {
    std::vector<std::string> lines;
    if (const auto moved = transformation(object.transform); !moved.empty()) lines.push_back(moved);
    if (object.inverse) lines.emplace_back("inverse");
    lines.insert(lines.end(), words.begin(), words.end());

    if (write_closed_torus(writer, object.shape, lines)) return;
    if (const auto* mesh = std::get_if<Mesh>(&object.shape)) {
        writer.open("mesh2");
        write_triangles(writer, *mesh->triangles);
    } else {
        const auto first = std::visit(
            [&]<class S>(const S& shape) -> std::string {
                if constexpr (std::same_as<S, Mesh>) {
                    return {};
                } else {
                    return head(shape);
                }
            },
            object.shape);
        if (lines.empty()) return writer.line("{} {{ {} }}", word(object.shape), first);
        writer.open(word(object.shape));
        writer.line("{}", first);
    }
    for (const auto& line : lines) writer.line("{}", line);
    writer.close();
}

}  // namespace meniscus::povray
