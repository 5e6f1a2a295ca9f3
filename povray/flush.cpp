#include "povray/flush.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "inspect/sample_lines.hpp"

namespace meniscus::povray {

Flush flush_faces(const tracer::RenderScene& scene, const tracer::Part& a, const tracer::Part& b) {
    using geom::Vec3;
    const double margin = 1e-9 * scene.size;
    constexpr double alike = 1e-6;
    std::map<geom::Face, std::vector<Vec3>> normals;
    const auto note = [&](const geom::Ray& line, double t, geom::Face face) {
        if (!std::isfinite(t) || face == geom::no_face) return;
        const Vec3 n = (a.inverse ? -1.0 : 1.0) * a.shape.normal(face, line.at(t));
        normals[face].push_back(n);
    };
    Flush result;
    const auto box = inspect::common_region(scene, a, b, 1e-3);
    if (box.is_empty()) return result;
    for (const auto& line : inspect::sample_lines(box, 64)) {
        const auto in_b = inspect::inside(b, line);
        for (const auto& i : inspect::inside(a, line)) {
            for (const auto& j : in_b) {
                if (std::abs(i.begin - j.begin) <= margin) note(line, i.begin, i.first);
                if (std::abs(i.end - j.end) <= margin) note(line, i.end, i.last);
            }
        }
    }
    for (const auto& [face, found] : normals) {
        const auto is_near = [&](const Vec3& n) {
            return [&](const Vec3& other) { return glm::length(other - n) < alike; };
        };
        if (!std::ranges::all_of(found, is_near(found.front()))) {
            result.curved = true;
        } else if (std::ranges::none_of(result.flat, is_near(found.front()))) {
            result.flat.push_back(found.front());
        }
    }
    constexpr std::size_t most_flat_faces = 6;
    if (result.flat.size() > most_flat_faces) {  // a curved face of a mesh
        result.flat.clear();
        result.curved = true;
    }
    return result;
}

}  // namespace meniscus::povray
