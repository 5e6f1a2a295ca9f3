#include "tracer/lane_groups.hpp"

#include <algorithm>

#include "geom/bounds.hpp"
#include "tracer/lane_solid.hpp"

namespace meniscus::tracer {
namespace {

/// Puts spheres that lie close together into groups of eight, by median splits.
void group(std::vector<int> ranks, lanes::Program& program) {
    const auto& members = program.members;
    if (ranks.size() > std::size_t(lanes::Group::size)) {
        geom::Bounds bounds;
        for (const int rank : ranks) {
            const geom::Vec3& c = members[std::size_t(rank)].center;
            bounds.extend(geom::Bounds{c, c});
        }
        const geom::Vec3 size = bounds.size();
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        std::ranges::sort(ranks, [&](int a, int b) {
            const double x = members[std::size_t(a)].center[axis],
                         y = members[std::size_t(b)].center[axis];
            return x != y ? x < y : a < b;
        });
        // Whole groups on the left, so that few stay partly empty.
        const std::size_t groups = (ranks.size() + lanes::Group::size - 1) / lanes::Group::size;
        const auto middle = ranks.begin() + std::ptrdiff_t(groups / 2 * lanes::Group::size);
        group({ranks.begin(), middle}, program);
        group({middle, ranks.end()}, program);
        return;
    }
    lanes::Group result{};
    for (std::size_t i = 0; i < std::size_t(lanes::Group::size); ++i) {
        const bool exists = i < ranks.size();
        result.rank[i] = exists ? ranks[i] : lanes::no_rank;
    }
    program.groups.push_back(result);
}

/// A sphere as rays in single precision see it (lanes::Group).
struct Seen {
    float x = 0.0f, y = 0.0f, z = 0.0f, reach = 0.0f, power = -1e9f;  // never met
};
Seen see(const lanes::Program& program, const geom::Vec3& center, double radius) {
    const double reach = radius / program.groups_reach + lanes::group_slack;
    const geom::Vec3 offset = (center - program.groups_middle) / program.groups_reach;
    return {float(offset.x), float(offset.y), float(offset.z), float(reach),
            float(reach * reach - glm::dot(offset, offset) + lanes::group_slack)};
}

/// Puts spheres around groups, and one around all.
void bound_groups(lanes::Program& program) {
    const auto bounds_of = [&](const lanes::Group& group) {
        geom::Bounds bounds;
        for (const int rank : group.rank) {
            if (rank < 0) continue;
            const lanes::Member& member = program.members[std::size_t(rank)];
            bounds.extend(
                geom::Bounds{member.center - member.radius, member.center + member.radius});
        }
        return bounds;
    };
    geom::Bounds all;
    for (const lanes::Group& group : program.groups) all.extend(bounds_of(group));
    program.groups_middle = 0.5 * (all.low + all.high);
    program.groups_reach = sphere_around(all, program.groups_middle);
    for (lanes::Group& group : program.groups) {
        const geom::Bounds bounds = bounds_of(group);
        const geom::Vec3 center = 0.5 * (bounds.low + bounds.high);
        double reach = 0.0;
        for (const int rank : group.rank) {
            if (rank < 0) continue;
            const lanes::Member& member = program.members[std::size_t(rank)];
            reach = std::max(reach, glm::length(member.center - center) + member.radius);
        }
        const Seen around = see(program, center, reach);
        group.x = around.x;
        group.y = around.y;
        group.z = around.z;
        group.reach = around.reach;
        group.power = around.power;
        for (std::size_t i = 0; i < group.rank.size(); ++i) {
            Seen sphere;
            if (group.rank[i] >= 0) {
                const lanes::Member& member = program.members[std::size_t(group.rank[i])];
                sphere = see(program, member.center, member.radius);
            }
            group.spheres.x[i] = sphere.x;
            group.spheres.y[i] = sphere.y;
            group.spheres.z[i] = sphere.z;
            group.spheres.reach[i] = sphere.reach;
            group.spheres.power[i] = sphere.power;
        }
    }
}

}  // namespace

void group_small_spheres(std::vector<int> ranks, lanes::Program& program) {
    group(std::move(ranks), program);
    bound_groups(program);
}

}  // namespace meniscus::tracer
