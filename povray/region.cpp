#include "povray/region.hpp"

#include <algorithm>

#include "povray/flush.hpp"
#include "povray/grow.hpp"

namespace meniscus::povray {
namespace {

/// Bodies grow by nothing or by 1, 1.2, 1.4 ... hairs and are cut at depths of 1.1, 1.3, 1.5 ...:
/// so no two of the faces that meet in one place come nearer to each other than a tenth of a hair.
constexpr double rank_step = 0.2;
constexpr double first_growth = 1.0, first_depth = 1.1;

const scene::Object& object_of(const tracer::RenderScene& scene, int part) {
    return scene.source.objects[std::size_t(scene.parts[std::size_t(part)].object)];
}

/// A cutter that ends flush with the body also cuts what lies behind that face.
void extend(const tracer::RenderScene& scene, const Body& body, int part, const Cutter& cutter,
            double hair, std::vector<Cutter>& result) {
    const double reach = hair * (4.0 + 2.0 * body.rank);
    for (const int mine : body.parts) {
        for (const auto& normal :
             flush_normals(scene, scene.parts[std::size_t(part)], scene.parts[std::size_t(mine)])) {
            result.push_back(cutter);
            auto& moved = result.back().object;
            moved.transform = moved.transform.then(geom::Transform::translation(reach * normal));
        }
    }
}

}  // namespace

double growth(const Plan& plan, const Body& body, Model model, double hair) {
    if (model != Model::contact) return 0.0;
    const auto is_outside = [&](int index) { return plan.bodies[std::size_t(index)].is_outside; };
    // All that meet: where air of a higher priority cuts both, each must reach beyond the cut.
    const bool meets = body.meets_opaque || !std::ranges::all_of(body.higher, is_outside) ||
                       !std::ranges::all_of(body.lower, is_outside);
    return meets ? hair * (first_growth + rank_step * body.rank) : 0.0;
}

std::vector<Cutter> cutters(const tracer::RenderScene& scene, const Plan& plan, const Body& body,
                            Model model, double hair) {
    std::vector<Cutter> result;
    if (model == Model::plain) return result;
    for (const int index : body.higher) {
        const Body& other = plan.bodies[std::size_t(index)];
        const bool is_film = model == Model::gap && !other.is_outside;
        const double distance = other.is_outside ? 0.0
                                : is_film        ? hair
                                                 : -hair * (first_depth + rank_step * body.rank);
        for (const int part : other.parts) {
            const auto& theirs = object_of(scene, part);
            const Cutter cutter{grown(theirs, distance), is_film ? clear_skin : theirs.texture};
            result.push_back(cutter);
            if (!is_film) extend(scene, body, part, cutter, hair, result);
        }
    }
    if (model == Model::gap) {
        for (const int part : body.touched)
            result.push_back({grown(object_of(scene, part), hair), clear_skin});
    }
    return result;
}

}  // namespace meniscus::povray
