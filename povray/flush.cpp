#include "povray/flush.hpp"

#include <algorithm>
#include <cmath>

#include "inspect/sample_lines.hpp"

namespace meniscus::povray {

std::vector<geom::Vec3> flush_normals(const tracer::RenderScene& scene, const tracer::Part& a,
                                      const tracer::Part& b) {
    using geom::Vec3;
    const double margin = 1e-9 * scene.size;
    std::vector<Vec3> normals;
    const auto note = [&](const geom::Ray& line, double t, geom::Face face) {
        if (!std::isfinite(t) || face == geom::no_face) return;
        const Vec3 n = (a.inverse ? -1.0 : 1.0) * a.shape.normal(face, line.at(t));
        const auto is_same = [&](const Vec3& other) { return glm::length(other - n) < 1e-6; };
        if (std::ranges::none_of(normals, is_same)) normals.push_back(n);
    };
    const auto box = inspect::common_region(scene, a, b, 1e-3);
    if (box.is_empty()) return normals;
    for (const auto& line : inspect::sample_lines(box, 64)) {
        const auto in_b = inspect::inside(b, line);
        for (const auto& i : inspect::inside(a, line)) {
            for (const auto& j : in_b) {
                if (std::abs(i.begin - j.begin) <= margin) note(line, i.begin, i.first);
                if (std::abs(i.end - j.end) <= margin) note(line, i.end, i.last);
            }
        }
    }
    constexpr std::size_t most_flat_faces = 6;
    if (normals.size() > most_flat_faces) normals.clear();  // a curved face
    return normals;
}

}  // namespace meniscus::povray
