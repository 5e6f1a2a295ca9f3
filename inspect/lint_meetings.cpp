#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "inspect/lints.hpp"
#include "inspect/meeting.hpp"
#include "inspect/sample_lines.hpp"

namespace meniscus::inspect {
namespace {

using tracer::Part;
using tracer::RenderScene;

/// Fewer for each pair where there are many of them.
int lines_per_axis(std::size_t pairs) {
    return int(std::clamp<std::size_t>(200'000 / (pairs + 1), 4, 64));
}

const scene::Location& location(const RenderScene& scene, const Part& part) {
    return scene.source.objects[std::size_t(part.object)].location;
}

const scene::Interior& interior(const RenderScene& scene, const Part& part) {
    return scene.source.solids[std::size_t(part.solid)].interior;
}

std::string unlike(const scene::Interior& a, const scene::Interior& b) {
    if (a.ior != b.ior) return fmt::format("ior {} and {}", text(a.ior), text(b.ior));
    return "of unlike absorption";
}

/// Two parts, of two solids or of a union, and how they meet.
struct Pair {
    const RenderScene& scene;
    const Names& names;
    const Part &a, &b;
    Meeting meeting;
};

using Findings = std::vector<Finding>;

// Each adds a finding if there is one, and says so.

bool add_overlap(const Pair& pair, Findings& findings) {
    const auto& [scene, names, a, b, meeting] = pair;
    if (!meeting.overlap || a.priority != b.priority) return false;
    if (interior(scene, a).same_medium(interior(scene, b))) return false;
    findings.push_back(
        {.severity = Finding::Severity::warning,
         .lint = "equal-priority-overlap",
         .location = location(scene, b),
         .text = fmt::format(
             "{} and {} overlap, as at {} by {}, and both have priority {} ({}): the one that a "
             "ray entered last is there, so that it may look different from elsewhere",
             names.object(a.object), names.object(b.object), text(meeting.overlap->position),
             text(meeting.overlap->depth), text(a.priority),
             unlike(interior(scene, a), interior(scene, b))),
         .advice = fmt::format("give the one that is there a higher priority, as `priority {}`",
                               text(std::floor(a.priority) + 1.0)),
         .related = {{location(scene, a), names.object(a.object) + " is here"}},
         .position = meeting.overlap->position,
         .depth = meeting.overlap->depth});
    return true;
}

bool add_gap(const Pair& pair, Findings& findings) {
    const auto& [scene, names, a, b, meeting] = pair;
    if (meeting.gaps.size() < fewest_slits) return false;
    const auto widest = std::ranges::max_element(meeting.gaps, {}, &Gap::width);
    findings.push_back(
        {.severity = Finding::Severity::warning,
         .lint = "thin-gap",
         .location = location(scene, b),
         .text = fmt::format("between {} and {} there is a gap of {}, as at {}: light is reflected "
                             "on both its sides as on any film",
                             names.object(a.object), names.object(b.object), text(widest->width),
                             text(widest->position)),
         .advice = fmt::format("let them overlap{}; or state "
                               "`global_settings {{ contact_tolerance {:.1g} }}`",
                               a.solid == b.solid ? "" : ", the higher priority wins",
                               4.0 * widest->width),
         .related = {{location(scene, a), names.object(a.object) + " is here"}},
         .position = widest->position,
         .depth = widest->width});
    return true;
}

bool add_film(const Pair& pair, Findings& findings) {
    const auto& [scene, names, a, b, meeting] = pair;
    if (meeting.films.size() < fewest_slits) return false;
    if (interior(scene, a).same_medium(interior(scene, b))) return false;
    const auto widest = std::ranges::max_element(meeting.films, {}, &Gap::width);
    const Part& low = a.priority < b.priority ? a : b;
    const Part& high = a.priority < b.priority ? b : a;
    findings.push_back(
        {.severity = Finding::Severity::warning,
         .lint = "thin-film",
         .location = location(scene, low),
         .text = fmt::format("{} sticks out of {} by {}, as at {}: a film of it lies there",
                             names.with_priority(low.solid), names.with_priority(high.solid),
                             text(widest->width), text(widest->position)),
         .advice = fmt::format("let it end where the other does, or well inside; or state "
                               "`global_settings {{ contact_tolerance {:.1g} }}`",
                               4.0 * widest->width),
         .related = {{location(scene, high), names.object(high.object) + " is here"}},
         .position = widest->position,
         .depth = widest->width});
    return true;
}

}  // namespace

void find_bad_meetings(const RenderScene& scene, const Names& names, Findings& findings) {
    constexpr std::array rules = {add_overlap, add_gap, add_film};
    std::array<std::set<std::pair<int, int>>, rules.size()> done;  // pairs of solids
    const auto pairs = neighbours(scene, thin, Pairing::all);
    for (const auto& [i, j] : pairs) {
        const Part& a = scene.parts[std::size_t(i)];
        const Part& b = scene.parts[std::size_t(j)];
        const std::pair<int, int> solids = std::minmax(a.solid, b.solid);
        const Pair pair{scene, names, a, b, meet(scene, a, b, lines_per_axis(pairs.size()))};
        for (std::size_t rule = 0; rule < rules.size(); ++rule) {
            if (!done[rule].contains(solids) && rules[rule](pair, findings))
                done[rule].insert(solids);
        }
    }
}

}  // namespace meniscus::inspect
