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
    std::vector<int> place(scene.parts.size(), -1);  // in `parts`
    for (std::size_t i = 0; i < parts.size(); ++i) place[std::size_t(parts[i])] = int(i);
    std::vector<double> result(parts.size(), 0.0);
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const auto& part = scene.parts[std::size_t(parts[i])];
        std::vector<int> earlier;
        const auto look = [&](int other) {
            const int k = place[std::size_t(other)];
            if (k >= 0 && k < int(i)) earlier.push_back(k);
        };
        for (const int other : scene.unbounded) look(other);
        scene.bvh.overlapping(part.shape.bounds().padded(1e-6 * scene.size),
                              [&](std::uint32_t box) { look(scene.bvh_parts[box]); });
        std::ranges::sort(earlier);
        for (const int k : earlier) {
            const double theirs = result[std::size_t(k)];
            if (result[i] <= theirs &&
                have_face_in_common(scene, part, scene.parts[std::size_t(parts[std::size_t(k)])]))
                result[i] = theirs + sliver;
        }
    }
    return result;
}

}  // namespace meniscus::povray
