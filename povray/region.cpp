#include "povray/region.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "povray/apart.hpp"
#include "povray/coincidence.hpp"
#include "povray/flush.hpp"
#include "povray/grow.hpp"

namespace meniscus::povray {
namespace {

/// Bodies grow by nothing or by 1, 1.2, 1.4 ... hairs and are cut at depths of 1.1, 1.3, 1.5 ...:
/// so no two of the faces that meet in one place come nearer to each other than a tenth of a hair.
constexpr double rank_step = 0.2;
constexpr double first_growth = 1.0, first_depth = 1.1, copy_step = 0.1;

const scene::Object& object_of(const tracer::RenderScene& scene, int part) {
    return scene.source.objects[std::size_t(scene.parts[std::size_t(part)].object)];
}

/// A cylinder or cone whose side reaches out by `reach` while its ends stay as they are.
bool widen(scene::Object& object, double reach) {
    const scene::Object wide = grown(object, reach);
    if (auto* shape = std::get_if<geom::Cylinder>(&object.shape)) {
        shape->radius = std::get<geom::Cylinder>(wide.shape).radius;
        return true;
    }
    if (auto* shape = std::get_if<geom::Cone>(&object.shape)) {
        shape->base_radius = std::get<geom::Cone>(wide.shape).base_radius;
        shape->cap_radius = std::get<geom::Cone>(wide.shape).cap_radius;
        return true;
    }
    return false;
}

bool comes_near(const tracer::RenderScene& scene, const Body& body, int part, double distance) {
    return !std::ranges::all_of(body.parts, [&](int mine) {
        return are_apart(scene.parts[std::size_t(mine)], scene.parts[std::size_t(part)], distance);
    });
}

/// A cutter that ends flush with a part of the body also cuts what lies behind that face: copies of
/// it, a little smaller so that no two have a face in common, reach beyond. Other parts may rightly
/// be there.
void extend(const tracer::RenderScene& scene, const Body& body, int part, double distance,
            double hair, std::vector<Cutter>& result, std::vector<std::string>& warnings) {
    const auto& theirs = object_of(scene, part);
    const double reach = hair * (4.0 + 2.0 * body.rank);
    for (const int mine : body.parts) {
        const auto& own = scene.parts[std::size_t(mine)];
        const Flush flush = flush_faces(scene, scene.parts[std::size_t(part)], own);
        if (flush.flat.empty() && !flush.curved) continue;
        const Cutter smaller{grown(theirs, distance - copy_step * hair), theirs.texture, {}, mine};
        for (const auto& normal : flush.flat) {
            result.push_back(smaller);
            auto& moved = result.back().object;
            moved.transform = moved.transform.then(geom::Transform::translation(reach * normal));
        }
        if (!flush.curved) continue;
        Cutter wide = smaller;
        if (widen(wide.object, reach)) {
            result.push_back(wide);
        } else {
            const auto& object = object_of(scene, mine);
            warnings.push_back(fmt::format(
                "{}:{}: '{}' and the higher '{}' have a curved outer wall in common, where a skin "
                "of the former stays in the export; let it end inside of the other",
                object.location.file, object.location.line, object.name, theirs.name));
        }
    }
}

/// Where an opaque solid touches the one above, the cutter, smaller by a hair, leaves a skin of the
/// body between the two, in which light would be bent before it meets the opaque one: it is taken
/// away up to that, and a little beyond.
void take_skins(const tracer::RenderScene& scene, const Body& body, const Body& other, double hair,
                std::vector<Cutter>& result) {
    const double beyond = hair * (4.0 + 2.0 * body.rank);
    for (const int opaque : other.touched) {
        if (!comes_near(scene, body, opaque, beyond)) continue;
        for (const int part : other.parts) {
            const auto& theirs = object_of(scene, part);
            result.push_back({grown(theirs, beyond),
                              theirs.texture,
                              grown(object_of(scene, opaque), beyond + hair),
                              {}});
        }
    }
}

/// Of what no light gets into, faces that are cut look as the rest does: where a higher solid ends
/// in it, it is what is seen.
void take_own_texture(const tracer::RenderScene& scene, const Body& body,
                      std::vector<Cutter>& result, std::vector<std::string>& warnings) {
    const auto is_opaque = [&](int part) { return scene.parts[std::size_t(part)].is_opaque; };
    if (result.empty() || std::ranges::none_of(body.parts, is_opaque)) return;
    const auto& first = object_of(scene, *std::ranges::find_if(body.parts, is_opaque));
    for (auto& cutter : result) cutter.texture = first.texture;
    if (std::ranges::any_of(body.parts, [&](int part) {
            return object_of(scene, part).texture != first.texture;
        })) {
        warnings.push_back(fmt::format(
            "{}:{}: of '{}' and the parts joined with it, unlike in texture, the faces where a "
            "higher solid cuts them all get the texture of this one",
            first.location.file, first.location.line, first.name));
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
                            Model model, double hair, double sliver,
                            std::vector<std::string>& warnings) {
    std::vector<Cutter> result;
    if (model == Model::plain) return result;
    // The films about opaque solids are above all bodies.
    std::vector<int> films;
    if (model == Model::gap) {
        for (const int part : plan.filmed) {
            if (comes_near(scene, body, part, hair + touching_distance(scene)))
                films.push_back(part);
        }
    }
    std::vector<int> all;
    for (const int index : body.higher) {
        const auto& parts = plan.bodies[std::size_t(index)].parts;
        all.insert(all.end(), parts.begin(), parts.end());
    }
    all.insert(all.end(), films.begin(), films.end());
    const auto apart = growth_apart(scene, all, sliver);
    auto more = apart.begin();
    for (const int index : body.higher) {
        const Body& other = plan.bodies[std::size_t(index)];
        const bool is_film = model == Model::gap && !other.is_outside;
        const double distance = other.is_outside ? 0.0
                                : is_film        ? hair
                                                 : -hair * (first_depth + rank_step * body.rank);
        for (const int part : other.parts) {
            const auto& theirs = object_of(scene, part);
            result.push_back(
                {grown(theirs, distance + *more++), is_film ? clear_skin : theirs.texture, {}, {}});
            if (!is_film) extend(scene, body, part, distance, hair, result, warnings);
        }
        if (model == Model::contact && !other.is_outside)
            take_skins(scene, body, other, hair, result);
    }
    for (const int part : films)
        result.push_back({grown(object_of(scene, part), hair + *more++), clear_skin, {}, {}});
    take_own_texture(scene, body, result, warnings);
    return result;
}

}  // namespace meniscus::povray
