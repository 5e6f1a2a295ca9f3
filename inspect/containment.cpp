#include "inspect/containment.hpp"

#include <algorithm>

#include "inspect/sample_lines.hpp"
#include "tracer/containment.hpp"

namespace meniscus::inspect {
namespace {

using tracer::Part;

bool is_inside_on_lines(const Part& inner, const Part& outer) {
    constexpr int lines_per_axis = 24;
    bool meets = false;
    for (const geom::Ray& line : sample_lines(inner.shape.bounds(), lines_per_axis)) {
        const auto in_outer = inside(outer, line);
        for (const Inside& stretch : inside(inner, line)) {
            meets = true;
            const bool covered = std::ranges::any_of(in_outer, [&](const Inside& cover) {
                return cover.begin <= stretch.begin && stretch.end <= cover.end;
            });
            if (!covered) return false;
        }
    }
    return meets;
}

}  // namespace

Containment contained(const Part& inner, const Part& outer) {
    if (inner.inverse || outer.inverse || !inner.shape.bounds().is_finite()) return Containment::no;
    const auto certain = tracer::is_contained(inner.shape, outer.shape, 0.0);
    if (certain && *certain) return Containment::certain;
    if (certain && outer.shape.transform().is_identity()) return Containment::no;
    return is_inside_on_lines(inner, outer) ? Containment::sampled : Containment::no;
}

}  // namespace meniscus::inspect
