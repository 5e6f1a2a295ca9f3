#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "inspect/containment.hpp"
#include "inspect/lints.hpp"
#include "inspect/sample_lines.hpp"

namespace meniscus::inspect {
namespace {

using tracer::Part;
using tracer::RenderScene;

/// Whether the inner one is small enough; the bounds of what is turned are larger than it is, but
/// not twice as large.
bool may_fit(const geom::Bounds& outer, const geom::Bounds& inner) {
    return 0.5 * geom::max_abs(inner.size()) <= geom::max_abs(outer.size());
}

/// By which part a part is hidden, and how sure that is.
struct Hiding {
    int by;
    Containment how;
};

}  // namespace

void find_hidden_solids(const RenderScene& scene, const Names& names,
                        std::vector<Finding>& findings) {
    std::map<int, Hiding> hidden;  // part -> what hides it
    for (const auto& [i, j] : neighbours(scene, 0.0)) {
        const bool i_is_lower =
            scene.parts[std::size_t(i)].priority < scene.parts[std::size_t(j)].priority;
        const int low = i_is_lower ? i : j, high = i_is_lower ? j : i;
        const Part& inner = scene.parts[std::size_t(low)];
        const Part& outer = scene.parts[std::size_t(high)];
        if (!(inner.priority < outer.priority)) continue;
        const auto known = hidden.find(low);
        if (known != hidden.end() && known->second.how == Containment::certain) continue;
        if (!may_fit(outer.shape.bounds(), inner.shape.bounds())) continue;
        const Containment how = contained(inner, outer);
        if (how == Containment::certain || (how == Containment::sampled && known == hidden.end()))
            hidden[low] = {high, how};
    }

    std::map<int, std::vector<int>> parts_of;  // solid -> its parts
    for (std::size_t i = 0; i < scene.parts.size(); ++i)
        parts_of[scene.parts[i].solid].push_back(int(i));
    for (const auto& [solid, parts] : parts_of) {
        const auto is_hidden = [&](int part) { return hidden.contains(part); };
        if (!std::ranges::all_of(parts, is_hidden)) continue;
        const bool is_certain = std::ranges::all_of(
            parts, [&](int part) { return hidden.at(part).how == Containment::certain; });
        const Part& part = scene.parts[std::size_t(parts.front())];
        const Part& outer = scene.parts[std::size_t(hidden.at(parts.front()).by)];
        const auto& place = scene.source.objects[std::size_t(outer.object)].location;
        Finding finding;
        finding.lint = "hidden-solid";
        finding.location = scene.source.objects[std::size_t(part.object)].location;
        finding.text = fmt::format("{} lies wholly inside {}{}: it is never there",
                                   names.with_priority(solid), names.with_priority(outer.solid),
                                   is_certain ? "" : " as far as sample lines show");
        finding.advice = fmt::format("to make it visible, give it `priority {}` or more",
                                     text(std::floor(outer.priority) + 1.0));
        finding.related = {{place, names.object(outer.object) + " is here"}};
        finding.position = part.shape.bounds().center();
        findings.push_back(std::move(finding));
    }
}

}  // namespace meniscus::inspect
