#include "povray/slits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "inspect/meeting.hpp"
#include "inspect/names.hpp"
#include "inspect/sample_lines.hpp"

namespace meniscus::povray {
namespace {

using inspect::Gap;
using tracer::Part;
using tracer::RenderScene;

/// Lines on which a slit must be seen, as for `check`: a round solid that touches another is that
/// near to it on hardly any.
constexpr std::size_t fewest = 3;

/// Fewer for each pair where there are many of them.
int lines_per_axis(std::size_t pairs) {
    return int(std::clamp<std::size_t>(200'000 / (pairs + 1), 4, 64));
}

/// Dielectrics beside dielectrics and beside opaque solids.
std::vector<std::pair<int, int>> pairs_within(const RenderScene& scene, double distance) {
    const auto bounds = [&](int i) {
        const Part& part = scene.parts[std::size_t(i)];
        return part.inverse ? geom::Bounds::everything() : part.shape.bounds();
    };
    std::vector<std::pair<int, int>> pairs;
    for (int a = 0; a < int(scene.parts.size()); ++a) {
        const Part& first = scene.parts[std::size_t(a)];
        if (!first.is_member) continue;
        const auto near = bounds(a).padded(distance);
        const auto add = [&](int b) {
            const Part& second = scene.parts[std::size_t(b)];
            if (second.is_member ? a >= b || first.solid == second.solid
                                 : !second.is_opaque || !second.shape.is_closed())
                return;
            if (geom::overlap(near, bounds(b))) pairs.emplace_back(a, b);
        };
        for (int b = 0; b < int(scene.parts.size()); ++b) add(b);
    }
    return pairs;
}

/// Of those that count the middle one: a line that grazes a curved wall tells too much.
std::optional<Gap> typical(std::vector<Gap> slits, double least) {
    std::erase_if(slits, [&](const Gap& slit) { return slit.width <= least; });
    if (slits.size() < fewest) return std::nullopt;
    const auto middle = slits.begin() + std::ptrdiff_t(slits.size() / 2);
    std::ranges::nth_element(slits, middle, {}, &Gap::width);
    return *middle;
}

}  // namespace

std::vector<std::string> slit_warnings(const RenderScene& scene, double least) {
    std::vector<std::string> warnings;
    const double tolerance = scene.contact_tolerance;
    if (!(tolerance > least)) return warnings;
    const inspect::Names names(scene.source);
    const auto place = [&](const Part& part) {
        return inspect::place(scene.source.objects[std::size_t(part.object)].location);
    };
    std::set<std::pair<std::string, std::string>> done;  // places: a loop's are said once
    const auto pairs = pairs_within(scene, tolerance);
    for (const auto& [i, j] : pairs) {
        const Part& a = scene.parts[std::size_t(i)];
        const Part& b = scene.parts[std::size_t(j)];
        if (done.contains({place(a), place(b)})) continue;
        const auto meeting =
            inspect::meet_within(scene, a, b, lines_per_axis(pairs.size()), tolerance);
        auto slit = typical(meeting.gaps, least);
        const auto& medium = scene.source.solids[std::size_t(a.solid)].interior;
        if (!slit && b.is_member &&
            !medium.same_medium(scene.source.solids[std::size_t(b.solid)].interior))
            slit = typical(meeting.films, least);
        if (!slit) continue;
        done.insert({place(a), place(b)});
        const auto where = b.is_member ? place(b) : place(a);
        warnings.push_back(fmt::format(
            "{}{}surfaces of {} and {} are {:.3g} apart, as at {}: one to Meniscus, by the "
            "scene's contact_tolerance of {:g}, but POV-Ray is given both and sees a film between "
            "them; let the solids overlap or end alike",
            where, where.empty() ? "" : ": ", names.object(a.object), names.object(b.object),
            slit->width, inspect::text(slit->position), tolerance));
    }
    return warnings;
}

}  // namespace meniscus::povray
