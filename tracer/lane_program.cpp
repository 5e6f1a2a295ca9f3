#include "tracer/lane_program.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "tracer/brightness.hpp"
#include "tracer/containment.hpp"
#include "tracer/interior_list.hpp"
#include "tracer/lane_bins.hpp"
#include "tracer/lane_groups.hpp"
#include "tracer/lane_paints.hpp"
#include "tracer/lane_solid.hpp"

namespace meniscus::tracer {
namespace {

/// Thrown while a program is made; never leaves this file.
struct CannotHave {
    std::string reason;
};

/// Spheres smaller than this share of the scene stand in groups where there are many.
constexpr double small_sphere = 0.25;
constexpr std::size_t few_solids = 8;
/// Of solids that reach farther than this share of the scene, some ray of a step comes near each.
constexpr double large_solid = 0.3;
/// Tolerances that differ by no more than this factor make the same picture (docs/numerics.md).
constexpr double alike_magnitudes = 8.0;

/// Whether it makes no difference which of two members of one priority a ray entered last.
bool are_alike(const RenderScene& scene, const Part& a, const Part& b) {
    return medium(scene, a.solid).same_medium(medium(scene, b.solid)) &&
           texture_of(scene, a).clear && texture_of(scene, b).clear;
}

bool may_meet(const Part& a, const Part& b, double margin) {
    return a.inverse || b.inverse || overlap(a.shape.bounds().padded(margin), b.shape.bounds());
}

void mark(lanes::Places& places, std::size_t place) { places[place / 64] |= 1ull << (place % 64); }

/// What is stronger than each member, and the ties; `members` are sorted by priority.
void compare_priorities(const RenderScene& scene, const std::vector<int>& members,
                        lanes::Program& program) {
    const auto part = [&](std::size_t rank) -> const Part& {
        return scene.parts[std::size_t(members[rank])];
    };
    const double margin = room_to_spare(scene);
    for (std::size_t first = 0, end; first < members.size(); first = end) {
        end = first + 1;
        while (end < members.size() && part(end).priority == part(first).priority) ++end;
        std::vector<std::size_t> tied;
        for (std::size_t i = first; i < end; ++i) {
            lanes::Places& stronger = program.members[i].stronger;
            bool is_tied = false;
            for (std::size_t j = first; j < members.size(); ++j) {
                const bool is_unlike = j < end && !are_alike(scene, part(i), part(j)) && i != j;
                if (i == j || !may_meet(part(i), part(j), margin)) continue;
                if (j > i && !is_unlike) mark(stronger, j);
                if (!is_unlike) continue;
                // Between these is no surface, whatever they look like.
                if (part(i).solid == part(j).solid)
                    throw CannotHave{"parts of one solid that meet and are not clear"};
                is_tied = true;
            }
            if (is_tied) tied.push_back(i);
        }
        if (tied.empty()) continue;
        lanes::Tie tie;
        std::vector<std::size_t> examples;
        for (const std::size_t i : tied) {
            const auto like = std::ranges::find_if(examples, [&](std::size_t example) {
                return are_alike(scene, part(i), part(example));
            });
            const auto kind = std::size_t(like - examples.begin());
            if (like == examples.end()) {
                examples.push_back(i);
                tie.kinds.emplace_back();
            }
            mark(tie.kinds[kind], i);
        }
        program.ties.push_back(tie);
    }
}

void check_parts(const RenderScene& scene) {
    double smallest = geom::infinity, farthest = geom::max_abs(scene.source.camera.location);
    for (const Part& part : scene.parts) {
        if (const auto* mesh = std::get_if<geom::Mesh>(&part.shape.shape());
            mesh && mesh->triangles->is_smooth())
            throw CannotHave{"a mesh with normals of its own"};
        if (!part.shape.is_closed()) throw CannotHave{"an open surface"};
        if (part.is_member && (part.no_image || part.no_reflection))
            throw CannotHave{"a medium that some rays do not see"};
        if (part.is_member && part.is_opaque) throw CannotHave{"an opaque solid with a priority"};
        if (texture_of(scene, part).finish.reflection.exponent != 1.0)
            throw CannotHave{"a reflection that is not linear"};
        if (medium(scene, part.solid).caustics != 0.0) throw CannotHave{"fake caustics"};
        const geom::Bounds& bounds = part.shape.bounds();
        if (!bounds.is_finite()) continue;
        const geom::Vec3 size = bounds.size();
        smallest = std::min({smallest, size.x, size.y, size.z});
        farthest = std::max({farthest, geom::max_abs(bounds.low), geom::max_abs(bounds.high)});
    }
    if (farthest > geom::far_from_origin * smallest)
        throw CannotHave{"solids too far from the origin for their size"};
    if (!scene.anchors.empty()) throw CannotHave{"thin films far from the origin"};
}

lanes::Member make_member(const RenderScene& scene, int index,
                          std::vector<const scene::Interior*>& media) {
    const Part& part = scene.parts[std::size_t(index)];
    const scene::Interior& interior = medium(scene, part.solid);
    lanes::Member member;
    member.part = index;
    member.ior = interior.ior;
    member.attenuates = interior.attenuates();
    member.clear = texture_of(scene, part).clear;
    const auto alike = std::ranges::find_if(
        media, [&](const scene::Interior* other) { return other->same_medium(interior); });
    member.medium = std::uint32_t(alike - media.begin());
    if (alike == media.end()) media.push_back(&interior);
    return member;
}

/// Whether the largest magnitude may stand for all. A tolerance goes by the sum of a crossing's
/// distance, its origin's coordinates and a magnitude; the first two together are no less than the
/// coordinates of the crossing, so than the least ones on the solid.
bool are_tolerances_alike(const RenderScene& scene, double largest) {
    int half_spaces = 0;
    return std::ranges::all_of(scene.parts, [&](const Part& part) {
        // The larger of two magnitudes counts: so one half-space, of whatever magnitude, has no
        // say.
        if (std::holds_alternative<geom::Plane>(part.shape.shape()) && ++half_spaces == 1)
            return true;
        const geom::Bounds& bounds = part.shape.bounds();
        double least = 0.0;
        for (int axis = 0; axis < 3; ++axis)
            least = std::max({least, bounds.low[axis], -bounds.high[axis]});
        return largest + least <= alike_magnitudes * (part.shape.magnitude() + least);
    });
}

bool ior_tells_medium(const lanes::Program& program) {
    std::vector<lanes::Member> all = program.members;
    all.push_back(program.outside);
    for (const auto& a : all) {
        for (const auto& b : all) {
            if ((a.ior == b.ior) != (a.medium == b.medium)) return false;
        }
    }
    return true;
}

/// Whether a ray's light is its weight in all channels: nothing but clear glass and paints, and no
/// sample counts more than another.
bool is_grey(const lanes::Program& program, const Options& options) {
    const auto* contrast = std::get_if<ContrastSampling>(&options.sampling);
    return !program.attenuates && !program.has_dressed && !(contrast && contrast->method == 2) &&
           options.filter == PixelFilter::box && program.all_painted;
}

lanes::Way way_of(const lanes::Solid& solid) {
    using lanes::Kind;
    using lanes::Way;
    if (solid.kind == Kind::mesh) return Way::mesh;
    if (lanes::is_plain_ball(solid)) return Way::ball;
    if (lanes::is_plain_floor(solid)) return Way::floor;
    if (!lanes::is_plain(solid)) return Way::any;
    if (solid.kind == Kind::cylinder && !solid.placed) return Way::cylinder;
    if (solid.kind == Kind::box) return Way::box;
    if (solid.kind == Kind::lathe && solid.is_stepped)
        return solid.is_cup ? Way::cup : Way::stepped_lathe;
    return Way::any;
}

lanes::Program make(const RenderScene& scene, const Options& options) {
    if (options.interior != InteriorMode::sweep) throw CannotHave{"another kind of list"};
    if (options.check_segments) throw CannotHave{"checks along each ray"};
    if (options.layers) throw CannotHave{"extra layers"};
    check_parts(scene);

    std::vector<int> members;
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        if (scene.parts[i].is_member) members.push_back(int(i));
    }
    if (members.size() > std::size_t(lanes::most_members))
        throw CannotHave{"more than " + std::to_string(lanes::most_members) + " solids"};
    std::ranges::stable_sort(members, {},
                             [&](int part) { return scene.parts[std::size_t(part)].priority; });

    lanes::Program program;
    std::vector<const scene::Interior*> media{&scene.source.settings.outside};
    program.outside.ior = scene.source.settings.outside.ior;
    program.outside.attenuates = scene.source.settings.outside.attenuates();
    std::vector<int> small;
    for (std::size_t rank = 0; rank < members.size(); ++rank) {
        const Part& part = scene.parts[std::size_t(members[rank])];
        lanes::Member member = make_member(scene, members[rank], media);
        const auto* sphere = std::get_if<geom::Sphere>(&part.shape.shape());
        member.in_group = scene.parts.size() > few_solids && sphere && !part.inverse &&
                          part.shape.transform().is_identity() &&
                          sphere->radius < small_sphere * scene.size;
        if (member.in_group) {
            member.center = sphere->center;
            member.radius = sphere->radius;
            member.inverse_radius = 1.0 / sphere->radius;
            small.push_back(int(rank));
        } else {
            program.solids.push_back(make_lane_solid(part, members[rank]));
            program.solids.back().rank = int(rank);
        }
        program.members.push_back(member);
    }
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        if (!scene.parts[i].is_member)
            program.solids.push_back(make_lane_solid(scene.parts[i], int(i)));
    }
    if (program.solids.size() > std::size_t(lanes::most_solids))
        throw CannotHave{"more than " + std::to_string(lanes::most_solids) +
                         " solids beside small spheres"};
    if (!small.empty()) group_small_spheres(std::move(small), program);
    for (const Part& part : scene.parts)
        program.largest_magnitude = std::max(program.largest_magnitude, part.shape.magnitude());
    program.one_tolerance = are_tolerances_alike(scene, program.largest_magnitude);
    int place = int(members.size());
    for (lanes::Solid& solid : program.solids) solid.place = solid.rank >= 0 ? solid.rank : place++;
    program.words = (place + 63) / 64;
    compare_priorities(scene, members, program);
    for (lanes::Solid& solid : program.solids) {
        if (solid.rank >= 0) solid.stronger = program.members[std::size_t(solid.rank)].stronger;
    }
    program.listed_solids = std::size_t(
        std::ranges::count_if(program.solids, [](const auto& solid) { return solid.rank >= 0; }));
    for (std::size_t rank = 0; rank < members.size(); ++rank) mark(program.member_bits, rank);
    program.has_surfaces =
        std::ranges::any_of(program.solids, [](const auto& solid) { return solid.rank < 0; });
    program.has_faces = std::ranges::any_of(
        program.solids, [](const auto& solid) { return lanes::has_faces(solid.kind); });
    program.has_dressed =
        std::ranges::any_of(program.members, [](const auto& member) { return !member.clear; });
    program.ior_tells_medium = ior_tells_medium(program);
    for (std::size_t i = 0; i < program.solids.size(); ++i) {
        auto& list =
            lanes::is_foreign(program.solids[i].kind) ? program.foreign : program.cheap_first;
        list.push_back(int(i));
        lanes::Solid& solid = program.solids[i];
        solid.way = way_of(solid);
        solid.is_large = solid.reach > large_solid * scene.size;
        const bool is_world_lathe =
            solid.kind == lanes::Kind::lathe && !solid.placed && !solid.inverse;
        auto& alike = solid.way == lanes::Way::ball    ? program.balls
                      : solid.way == lanes::Way::floor ? program.floors
                      : is_world_lathe                 ? program.lathes
                                                       : program.cornered;
        alike.push_back(int(i));
    }
    for (std::size_t i = program.listed_solids; i-- > 0;) {
        if (program.solids[i].kind == lanes::Kind::mesh) program.meshes.push_back(int(i));
    }
    for (std::size_t i = program.listed_solids; i < program.solids.size(); ++i) {
        if (program.solids[i].kind == lanes::Kind::mesh) program.meshes.push_back(int(i));
    }
    program.has_meshes = !program.meshes.empty();
    program.only_opaque_shades = scene.only_opaque_shades;
    for (const auto* list : {&program.cheap_first, &program.foreign}) {
        for (const int i : *list) {
            const lanes::Solid& solid = program.solids[std::size_t(i)];
            if (solid.rank < 0 && solid.to_lights) program.shades.push_back(i);
        }
    }
    std::ranges::stable_sort(program.cheap_first, {}, [&](int i) {
        // Those that are asked anyway come first: the others need not be where these are nearer.
        const lanes::Solid& solid = program.solids[std::size_t(i)];
        if (solid.is_large &&
            (solid.way == lanes::Way::cup || solid.way == lanes::Way::stepped_lathe))
            return 0;
        return solid.kind == lanes::Kind::lathe ? 2 : lanes::is_costly(solid.kind) ? 1 : 0;
    });
    make_bins(scene, program);
    program.attenuates = scene.has_attenuation;
    make_paints(scene, program);
    program.grey = is_grey(program, options);

    program.tolerance_units = scene.tolerance_units;
    program.contact_tolerance = scene.contact_tolerance;
    for (lanes::Solid& solid : program.solids) {
        solid.thin = 3.0 * lanes::thin_chord * solid.magnitude + 2.0 * scene.contact_tolerance;
        solid.sure_start = 2.0 * scene.tolerance_units * lanes::unit_roundoff * solid.magnitude;
    }
    const Tree tree = implied_tree(options);
    const scene::Settings& settings = scene.source.settings;
    program.whitted = tree == Tree::whitted;
    program.sampled = tree == Tree::sampled;
    program.most_levels = program.whitted ? settings.max_trace_level.value_or(5) : options.depth;
    program.least_weight = program.whitted      ? settings.adc_bailout.value_or(1.0 / 255.0)
                           : tree == Tree::full ? options.cutoff
                                                : 0.0;
    program.uses_keys =
        program.sampled || std::ranges::any_of(scene.source.textures, [](const auto& texture) {
            return texture.finish.crand != 0.0;
        });
    program.constant_sky = scene.source.sky_sphere.pigments.empty() && !program.outside.attenuates;
    program.sky = scene.source.background.rgb;
    // Room for 2^20 samples of the brightest light.
    const int exponent = std::ilogb(std::max(brightest(scene.source), 1e-30)) + 1;
    program.units = std::ldexp(1.0, 42 - exponent);
    return program;
}

}  // namespace

std::variant<lanes::Program, NoLanes> make_lane_program(const RenderScene& scene,
                                                        const Options& options) {
    try {
        return make(scene, options);
    } catch (const CannotHave& cannot) {
        return NoLanes{cannot.reason};
    }
}

}  // namespace meniscus::tracer
