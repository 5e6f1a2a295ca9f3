#include "povray/coincidence.hpp"

#include <algorithm>
#include <cmath>

#include "inspect/sample_lines.hpp"

namespace meniscus::povray {
namespace {

/// Whether lines find a face of both, their solids on one side of it or on both.
bool have_face_in_common(const tracer::RenderScene& scene, const tracer::Part& a,
                         const tracer::Part& b) {
    constexpr int sample_lines = 64;
    const double margin = 1e-9 * scene.size;
    const auto box = inspect::common_region(scene, a, b, 1e-3);
    if (box.is_empty()) return false;
    const auto meet = [&](double s, double t) { return std::abs(s - t) <= margin; };
    for (const auto& line : inspect::sample_lines(box, sample_lines)) {
        const auto in_b = inspect::inside(b, line);
        for (const auto& i : inspect::inside(a, line)) {
            if (std::ranges::any_of(in_b, [&](const auto& j) {
                    return meet(i.begin, j.begin) || meet(i.end, j.end) || meet(i.begin, j.end) ||
                           meet(i.end, j.begin);
                }))
                return true;
        }
    }
    return false;
}

}  // namespace

std::vector<double> growth_apart(const tracer::RenderScene& scene, const std::vector<int>& parts,
                                 double sliver) {
    std::vector<double> result(parts.size(), 0.0);
    for (std::size_t i = 1; i < parts.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            if (result[i] <= result[k] &&
                have_face_in_common(scene, scene.parts[std::size_t(parts[i])],
                                    scene.parts[std::size_t(parts[k])]))
                result[i] = result[k] + sliver;
        }
    }
    return result;
}

}  // namespace meniscus::povray
