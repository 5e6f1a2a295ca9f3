// What a ray may come to before it leaves the strongest solid that it is in: what has a surface
// there or near it. So nothing that is apart from that solid, nor what holds it all with room to
// spare. In the open it comes to nothing that another solid holds.

#include "tracer/lane_bins.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "tracer/containment.hpp"

namespace meniscus::tracer {
namespace {

using geom::PlacedShape;
using geom::Vec3;

/// Each of the strongest solids has a bin of its own, neighbouring ranks of small spheres have one
/// together.
constexpr std::size_t most_bins = 8;

class Reach {
public:
    Reach(const RenderScene& scene, const lanes::Program& program)
        : scene_(scene),
          program_(program),
          // Twice what the kernel takes for near an event inside of a solid (`list_event`).
          room_(room_to_spare(scene)) {}

    /// Of rays whose strongest solids are those of ranks from `first` to `last`.
    lanes::Surroundings of_members(std::size_t first, std::size_t last) const {
        auto result = around([&](const PlacedShape& to, const lanes::Solid* solid) {
            // They are in nothing stronger yet, so what that holds lies behind a true crossing.
            if (is_held(to, solid, last + 1)) return false;
            for (std::size_t rank = first; rank <= last; ++rank) {
                if (may_come(rank, to, solid)) return true;
            }
            return false;
        });
        for (std::size_t rank = first; rank <= last; ++rank)
            result.places[rank / 64] |= 1ull << (rank % 64);
        if (first == last) result.top = int(last);
        for (const int i : result.all)
            result.hiding[std::size_t(i)] = hiding(program_.solids[std::size_t(i)], first, last);
        return result;
    }
    lanes::Surroundings of_the_open() const {
        auto result = around([&](const PlacedShape& to, const lanes::Solid* solid) {
            return !is_held(to, solid, 0);
        });
        result.is_open = true;
        return result;
    }
    lanes::Surroundings everything() const {
        auto result = around([](const PlacedShape&, const lanes::Solid*) { return true; });
        result.hiding.fill(lanes::Hiding::by_list);
        return result;
    }

private:
    const Part& part(int index) const { return scene_.parts[std::size_t(index)]; }

    bool holds(const PlacedShape& outer, const PlacedShape& inner) const {
        return is_contained(inner, outer, room_).value_or(false);
    }

    /// Whether a solid of at least that rank holds a shape; of small spheres there is no `solid`.
    bool is_held(const PlacedShape& shape, const lanes::Solid* solid, std::size_t first) const {
        if (solid && solid->inverse) return false;
        for (std::size_t rank = first; rank < program_.members.size(); ++rank) {
            const Part& holder = part(program_.members[rank].part);
            if (!holder.inverse && &holder.shape != &shape && holds(holder.shape, shape))
                return true;
        }
        return false;
    }

    /// Whether a ray inside of a member may come to a surface before it has left that, or is in
    /// that small sphere.
    bool may_come(std::size_t rank, const PlacedShape& to, const lanes::Solid* solid) const {
        const Part& from = part(program_.members[rank].part);
        if (from.inverse || !from.shape.bounds().is_finite()) return true;
        if (&from.shape == &to) return true;
        const geom::Bounds around = from.shape.bounds().padded(room_);
        if (const auto* plane = std::get_if<geom::Plane>(&to.shape());
            plane && to.transform().is_identity()) {
            const Vec3 n = plane->normal(0, around.low);
            const double height = glm::dot(n, around.center()) - plane->distance;
            return std::abs(height) <= glm::dot(glm::abs(n), 0.5 * around.size());
        }
        if (to.bounds().is_finite() && !overlap(around, to.bounds())) return false;
        // Small spheres around are known to the kernel only if it asks for them.
        if (solid && holds(to, from.shape)) return false;
        if (solid && is_in_cavity(from.shape, *solid)) return false;
        const auto own = std::ranges::find(program_.solids, int(rank), &lanes::Solid::rank);
        return own == program_.solids.end() || !is_in_cavity(to, *own);
    }

    /// Whether a shape lies within a cup's walls and above its floor.
    bool is_in_cavity(const PlacedShape& shape, const lanes::Solid& solid) const {
        if (!solid.is_cup) return false;
        const lanes::Cup& cup = solid.cup;
        const double end = cup.floor + 1e6 * (cup.top - cup.base);  // as good as endless
        const geom::Cylinder cavity{{0.0, cup.floor, 0.0}, {0.0, end, 0.0}, cup.inner_radius};
        return holds({cavity, part(solid.part).shape.transform()}, shape);
    }

    /// Whether a solid is hidden from rays whose strongest are those of these ranks.
    lanes::Hiding hiding(const lanes::Solid& solid, std::size_t first, std::size_t last) const {
        const auto is_stronger = [&](std::size_t rank) {
            return (solid.stronger[rank / 64] >> (rank % 64) & 1u) != 0;
        };
        bool always = true, ever = false;
        for (std::size_t rank = 0; rank <= last; ++rank) {
            ever |= is_stronger(rank);
            always &= rank < first || is_stronger(rank);
        }
        return always ? lanes::Hiding::always
               : ever ? lanes::Hiding::by_list
                      : lanes::Hiding::never;
    }

    /// What rays may come to, if may_come(shape, solid) tells of each; of small spheres any.
    lanes::Surroundings around(auto&& may_come) const {
        lanes::Surroundings result;
        std::vector<bool> may;
        for (const lanes::Solid& solid : program_.solids) {
            // Meshes are asked last, no farther than they may count.
            const bool is_mesh = solid.kind == lanes::Kind::mesh;
            may.push_back(is_mesh || may_come(part(solid.part).shape, &solid));
        }
        const auto add = [&](const std::vector<int>& solids, std::vector<int>& to) {
            std::ranges::copy_if(solids, std::back_inserter(to),
                                 [&](int i) { return may[std::size_t(i)]; });
        };
        for (std::size_t i = 0; i < may.size(); ++i) {
            if (may[i]) result.all.push_back(int(i));
        }
        add(program_.balls, result.balls);
        add(program_.floors, result.floors);
        add(program_.cornered, result.cornered);
        add(program_.cheap_first, result.others);
        add(program_.foreign, result.foreign);
        std::erase_if(result.others, [&](int i) {
            return program_.solids[std::size_t(i)].way == lanes::Way::ball;
        });
        std::erase_if(result.foreign, [&](int i) {
            return program_.solids[std::size_t(i)].kind == lanes::Kind::mesh;
        });
        const auto is_among = [&](int i) { return may[std::size_t(i)]; };
        result.lathes = std::ranges::any_of(program_.lathes, is_among);
        result.surfaces = std::ranges::any_of(
            result.all, [&](int i) { return i >= int(program_.listed_solids); });
        result.small_spheres =
            std::ranges::any_of(program_.members, [&](const lanes::Member& member) {
                return member.in_group && may_come(part(member.part).shape, nullptr);
            });
        return result;
    }

    const RenderScene& scene_;
    const lanes::Program& program_;
    double room_;
};

}  // namespace

void make_bins(const RenderScene& scene, lanes::Program& program) {
    const Reach reach(scene, program);
    program.everything = reach.everything();
    const auto& members = program.members;
    for (std::size_t end = members.size(); end > 0;) {
        const std::size_t last = end - 1;
        std::size_t first = last;
        const bool is_full = program.bins.size() + 2 == most_bins;
        while (first > 0 && (is_full || (members[first].in_group && members[first - 1].in_group)))
            --first;
        program.bins.push_back(reach.of_members(first, last));
        end = first;
    }
    program.bins.push_back(reach.of_the_open());
}

}  // namespace meniscus::tracer
