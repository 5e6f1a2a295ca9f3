#include "inspect/reason.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace meniscus::inspect {
namespace {

using tracer::outside;
using tracer::Part;

double priority(const tracer::RenderScene& scene, int solid) {
    return scene.source.solids[std::size_t(solid)].interior.priority;
}

bool stays(const Listing& after, int solid) {
    return std::ranges::any_of(after.members,
                               [&](const auto& member) { return member.solid == solid; });
}

std::string why_replaced(const tracer::RenderScene& scene, const Names& names, int now,
                         int before) {
    if (before == outside) return names.with_priority(now) + " replaces the outside";
    if (priority(scene, now) > priority(scene, before)) {
        return fmt::format("{} is above {} and replaces it", names.with_priority(now),
                           names.with_priority(before));
    }
    return fmt::format("{} was entered last and replaces {}", names.with_priority(now),
                       names.with_priority(before));
}

}  // namespace

std::string why_false(const tracer::RenderScene& scene, const Names& names,
                      const tracer::Judged& crossing, const Step& step) {
    const int solid = scene.parts[std::size_t(crossing.part)].solid;
    const int top = step.before.top;
    if (step.crossings.size() > 1) {
        return fmt::format(
            "of the {} crossings in this place together: {} is there before and after",
            step.crossings.size(), names.solid(top));
    }
    if (top == outside) return "the outside is there before and after";
    if (solid == top) {
        return crossing.entering ? fmt::format("the ray is inside {} already", names.solid(top))
                                 : fmt::format("the ray is still inside {}", names.solid(top));
    }
    if (priority(scene, solid) < priority(scene, top)) {
        return fmt::format("{} is below {}, which is there", names.with_priority(solid),
                           names.with_priority(top));
    }
    if (stays(step.after, solid) && !crossing.entering) {
        return fmt::format("the ray is still inside {}", names.solid(solid));
    }
    return fmt::format("{} ties with {}, which was entered later and is there",
                       names.with_priority(solid), names.with_priority(top));
}

std::string why_true(const tracer::RenderScene& scene, const Names& names,
                     const tracer::Judged& crossing, const Step& step, const tracer::Event& event) {
    const Part& part = scene.parts[std::size_t(crossing.part)];
    if (!part.is_member) {
        return part.shape.is_closed() ? "an opaque surface is always met"
                                      : "an open surface is always met";
    }
    const int before = event.solid_before, after = event.solid_after;
    if (before == after) return "it lies where a surface is that is always met";
    if (step.crossings.size() > 1) {
        return fmt::format("{} crossings in this place are one: {} gives way to {}",
                           step.crossings.size(), names.with_priority(before),
                           names.with_priority(after));
    }
    if (crossing.entering) return why_replaced(scene, names, after, before);
    return after == outside
               ? fmt::format("{} ends and nothing else is there", names.with_priority(before))
               : fmt::format("{} ends and {} is next", names.with_priority(before),
                             names.with_priority(after));
}

}  // namespace meniscus::inspect
