#include "povray/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "inspect/containment.hpp"
#include "inspect/meeting.hpp"
#include "inspect/sample_lines.hpp"
#include "povray/apart.hpp"
#include "povray/error.hpp"

namespace meniscus::povray {
namespace {

using tracer::Part;
using tracer::RenderScene;

constexpr int sample_lines = 64;

/// "Glass"; "Sphere_12" for what has no name but its shape's; "_2" and so on for further ones.
std::string identifier(const scene::Solid& solid, std::set<std::string>& taken) {
    std::string name = solid.name.empty() ? "solid" : solid.name;
    if (name.front() >= 'a' && name.front() <= 'z') {
        name.front() = char(name.front() - 'a' + 'A');
        if (solid.location.line > 0) name += fmt::format("_{}", solid.location.line);
    }
    std::string result = name;
    for (int i = 2; !taken.insert(result).second; ++i) result = fmt::format("{}_{}", name, i);
    return result;
}

/// Whether all that lines find of `inner` lies in `outer`.
bool is_nested(const RenderScene& scene, const Part& inner, const Part& outer) {
    bool found = false;
    const auto box = inspect::common_region(scene, inner, inner, 0.0);
    for (const auto& line : inspect::sample_lines(box, sample_lines)) {
        for (const auto& i : inspect::inside(inner, line)) {
            found = true;
            const auto around = inspect::inside(outer, line);
            if (std::ranges::none_of(
                    around, [&](const auto& o) { return o.begin <= i.begin && i.end <= o.end; }))
                return false;
        }
    }
    return found;
}

/// Whether solid a is above b where both are: 1, -1, or 0 where they have nothing in common.
int compare(const RenderScene& scene, const Part& a, const Part& b) {
    if (a.priority != b.priority) return a.priority > b.priority ? 1 : -1;
    const auto& first = scene.source.solids[std::size_t(a.solid)];
    const auto& second = scene.source.solids[std::size_t(b.solid)];
    // The one entered last is there: the inner one. Where media are alike the order does not
    // matter.
    if (is_nested(scene, a, b)) return 1;
    if (is_nested(scene, b, a) || first.interior.same_medium(second.interior)) return -1;
    if (!inspect::meet(scene, a, b, sample_lines).overlap) return -1;
    throw ExportError(scene.source.objects[std::size_t(b.object)].location,
                      fmt::format("'{}' and '{}' overlap with the same priority {}: which of them "
                                  "is there depends on the ray, which no export can say; give one "
                                  "a higher priority",
                                  first.name, second.name, a.priority));
}

/// Whether one ends where the other begins, on some line.
bool is_touching(const RenderScene& scene, const Part& a, const Part& b, double margin) {
    if (!b.shape.is_closed()) return false;
    const auto box = inspect::common_region(scene, a, b, 1e-3);
    for (const auto& line : inspect::sample_lines(box, sample_lines)) {
        const auto in_b = inspect::inside(b, line);
        for (const auto& i : inspect::inside(a, line)) {
            for (const auto& j : in_b) {
                if (std::abs(i.end - j.begin) <= margin || std::abs(j.end - i.begin) <= margin)
                    return true;
            }
        }
    }
    return false;
}

/// Solids that are nowhere to be seen: each part lies in a part of a higher solid.
std::set<int> hidden_solids(const RenderScene& scene) {
    std::vector<bool> is_hidden(scene.parts.size(), false);
    const auto look = [&](int inner, int outer) {
        const Part& a = scene.parts[std::size_t(inner)];
        const Part& b = scene.parts[std::size_t(outer)];
        if (is_hidden[std::size_t(inner)] || !(a.priority < b.priority)) return;
        const auto how = inspect::contained(a, b);
        // What lines find is enough for two of one kind.
        is_hidden[std::size_t(inner)] = how == inspect::Containment::certain ||
                                        (how == inspect::Containment::sampled &&
                                         a.shape.shape().index() == b.shape.shape().index());
    };
    for (const auto& [a, b] : inspect::neighbours(scene, 1e-6)) {
        look(a, b);
        look(b, a);
    }
    std::set<int> result;
    for (std::size_t i = 0; i < scene.parts.size(); ++i)
        if (is_hidden[i]) result.insert(scene.parts[i].solid);
    for (std::size_t i = 0; i < scene.parts.size(); ++i)
        if (!is_hidden[i]) result.erase(scene.parts[i].solid);
    return result;
}

}  // namespace

Plan make_plain_plan(const RenderScene& scene) {
    Plan plan;
    std::map<int, std::size_t> body_of;
    std::set<std::string> taken = {"S", "Clear", "Silent"};
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        const Part& part = scene.parts[i];
        if (!part.is_member) {
            plan.plain_parts.push_back(int(i));
            continue;
        }
        const auto [found, is_new] = body_of.try_emplace(part.solid, plan.bodies.size());
        if (is_new) {
            const auto& solid = scene.source.solids[std::size_t(part.solid)];
            plan.bodies.push_back({.solid = part.solid,
                                   .name = identifier(solid, taken),
                                   .parts = {},
                                   .touched = {},
                                   .higher = {},
                                   .lower = {}});
        }
        plan.bodies[found->second].parts.push_back(int(i));
    }
    return plan;
}

Plan make_plan(const RenderScene& scene) {
    Plan plan = make_plain_plan(scene);
    auto& bodies = plan.bodies;
    const std::set<int> hidden = hidden_solids(scene);
    std::erase_if(bodies, [&](const Body& body) { return hidden.contains(body.solid); });
    std::map<int, int> body_of;
    for (std::size_t i = 0; i < bodies.size(); ++i) body_of[bodies[i].solid] = int(i);

    const double margin = touching_distance(scene);
    std::set<std::pair<int, int>> above;  // the first above the second
    for (const auto& [a, b] : inspect::neighbours(scene, 1e-6)) {
        const Part& first = scene.parts[std::size_t(a)];
        const Part& second = scene.parts[std::size_t(b)];
        if (hidden.contains(first.solid) || hidden.contains(second.solid)) continue;
        if (are_apart(first, second, margin)) continue;
        const int i = body_of.at(first.solid), j = body_of.at(second.solid);
        if (above.contains({i, j}) || above.contains({j, i})) continue;
        above.insert(compare(scene, first, second) > 0 ? std::pair{i, j} : std::pair{j, i});
    }
    for (const auto& [high, low] : above) {
        bodies[std::size_t(high)].lower.push_back(low);
        bodies[std::size_t(low)].higher.push_back(high);
    }
    // The rank: one more than the lowest rank of those above.
    for (std::size_t pass = 0; pass < bodies.size(); ++pass) {
        bool changed = false;
        for (Body& body : bodies) {
            int rank = 0;
            for (const int other : body.higher)
                rank = std::max(rank, bodies[std::size_t(other)].rank + 1);
            changed = changed || rank != body.rank;
            body.rank = rank;
        }
        if (!changed) break;
    }
    for (Body& body : bodies) {
        const auto& solid = scene.source.solids[std::size_t(body.solid)];
        body.is_outside = solid.interior.same_medium(scene.source.settings.outside);
        for (const int part : body.parts) {
            const auto& object =
                scene.source.objects[std::size_t(scene.parts[std::size_t(part)].object)];
            body.is_outside = body.is_outside && scene.source.textures[object.texture].clear;
            for (const int other : plan.plain_parts) {
                const Part& mine = scene.parts[std::size_t(part)];
                const Part& its = scene.parts[std::size_t(other)];
                if (are_apart(mine, its, margin)) continue;
                body.meets_opaque = true;
                if (is_touching(scene, mine, its, margin)) body.touched.push_back(other);
            }
        }
    }
    for (const Body& body : bodies) plan.filmed.insert(body.touched.begin(), body.touched.end());
    return plan;
}

}  // namespace meniscus::povray
