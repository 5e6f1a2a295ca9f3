#include "inspect/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

#include "inspect/lints.hpp"

namespace meniscus::inspect {
namespace {

constexpr auto lints = std::to_array<Lint*>({
    find_bad_meetings,
    find_hidden_solids,
    find_buried_solids,
    find_thin_solids,
    find_open_meshes,
    find_repaired_meshes,
    find_bad_shells,
    find_media_without_solid,
    find_hidden_iors,
    find_camera_in_media,
    find_camera_in_opaque,
    find_lost_sky,
    find_buried_lights,
});

using Place = std::tuple<std::string, int, int>;

Place place_in_text(const scene::Location& location) {
    return {location.file, location.line, location.column};
}

/// A loop makes many objects in one place of the text: one message is enough.
std::vector<Finding> merged(std::vector<Finding> findings) {
    std::vector<Finding> result;
    std::vector<int> more;
    std::map<std::pair<std::string, std::vector<Place>>, std::size_t> seen;
    for (Finding& finding : findings) {
        const bool has_place = finding.location.line > 0;
        std::vector<Place> places{place_in_text(finding.location)};
        for (const auto& related : finding.related)
            places.push_back(place_in_text(related.location));
        const auto [entry, is_new] = seen.try_emplace({finding.lint, places}, result.size());
        if (is_new || !has_place) {
            result.push_back(std::move(finding));
            more.push_back(0);
        } else {
            ++more[entry->second];
        }
    }
    for (std::size_t i = 0; i < result.size(); ++i) {
        if (more[i] > 0) result[i].text += fmt::format(" (and {} more from here)", more[i]);
    }
    return result;
}

}  // namespace

std::vector<Finding> check(const tracer::RenderScene& scene) {
    const Names names(scene.source);
    std::vector<Finding> findings;
    for (Lint* lint : lints) lint(scene, names, findings);
    findings = merged(std::move(findings));
    std::ranges::stable_sort(
        findings, {}, [](const Finding& finding) { return place_in_text(finding.location); });
    return findings;
}

std::vector<Finding> check_open_meshes(const tracer::RenderScene& scene) {
    std::vector<Finding> findings;
    find_open_meshes(scene, Names(scene.source), findings);
    return merged(std::move(findings));
}

}  // namespace meniscus::inspect
