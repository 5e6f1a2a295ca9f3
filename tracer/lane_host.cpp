#include "tracer/lane_host.hpp"

#include <algorithm>
#include <cmath>

#include "tracer/attenuation.hpp"
#include "tracer/camera_rays.hpp"
#include "tracer/pigment.hpp"
#include "tracer/sky.hpp"

namespace meniscus::tracer {

using geom::Vec3;
using scene::Rgb;

LaneHost::LaneHost(const RenderScene& scene, const Options& options, const lanes::Program& program,
                   RayTree& tree, Statistics& statistics)
    : scene_(scene),
      options_(options),
      program_(program),
      tree_(tree),
      statistics_(statistics),
      stacks_(program),
      rank_of_part_(scene.parts.size(), lanes::no_rank) {
    for (std::size_t rank = 0; rank < program.members.size(); ++rank)
        rank_of_part_[std::size_t(program.members[rank].part)] = int(rank);
    if (!is_camera_in_the_open()) return;
    const scene::Camera& camera = scene.source.camera;
    const geom::Ray ray = camera_ray(camera, 0.5 * options.width, 0.5 * options.height,
                                     options.width, options.height);
    camera_.emplace(lanes::Camera{.start = {},
                                  .forward = camera.direction,
                                  .right = camera.right,
                                  .up = camera.up,
                                  .width = double(options.width),
                                  .height = double(options.height)});
    list_start(tree.events().start(ray, RayKind::image), camera_->start);
    camera_->start.origin = ray.origin;
}

/// Whether all camera rays start in one place that is clear of every surface. Then they share one
/// list.
bool LaneHost::is_camera_in_the_open() const {
    const scene::Camera& camera = scene_.source.camera;
    if (camera.kind != scene::Camera::Kind::perspective) return false;
    const Vec3& p = camera.location;
    const double margin = 1e-6 * (geom::max_abs(p) + scene_.size) + scene_.contact_tolerance;
    for (const Part& part : scene_.parts) {
        if (const auto* plane = std::get_if<geom::Plane>(&part.shape.shape())) {
            const double depth = plane->distance - glm::dot(p, plane->normal(0, p));
            if (std::abs(depth) <= margin || !part.shape.transform().is_identity()) return false;
            continue;
        }
        const geom::Bounds bounds = part.shape.bounds().padded(margin);
        if (p.x >= bounds.low.x && p.y >= bounds.low.y && p.z >= bounds.low.z &&
            p.x <= bounds.high.x && p.y <= bounds.high.y && p.z <= bounds.high.z)
            return false;
    }
    return true;
}

void LaneHost::list_start(const TracedRay& start, lanes::WaitingRay& ray) const {
    for (const InteriorList::Member& member : start.interior) {
        if (member.depth <= 0) continue;
        const int rank = rank_of_part_[std::size_t(member.part)];
        ray.inside[std::size_t(rank / 64)] |= 1ull << (rank % 64);
    }
    ray.birth_magnitude = start.birth.magnitude;
}

/// Whether a list does not say which of two solids is on top.
bool LaneHost::is_tied(const lanes::Places& inside) const {
    return std::ranges::any_of(program_.ties, [&](const lanes::Tie& tie) {
        return std::ranges::count_if(tie.kinds, [&](const lanes::Places& kind) {
                   for (std::size_t w = 0; w < kind.size(); ++w) {
                       if (inside[w] & kind[w]) return true;
                   }
                   return false;
               }) > 1;
    });
}

void LaneHost::add_light(const Sample& sample, const Rgb& light) {
    std::int64_t* sum = &sums_[4 * sample.target];
    for (int i = 0; i < 3; ++i)
        sum[i] += std::int64_t(std::llrint(sample.weight * light[i] * program_.units));
    ++sum[3];
}

/// How many samples are left, fetched if there were none.
std::size_t LaneHost::samples_at_hand() {
    if (next_sample_ == samples_.size()) {
        samples_.clear();
        next_sample_ = 0;
        (*more_)(samples_);
    }
    return samples_.size() - next_sample_;
}

void LaneHost::run(const MoreSamples& more, std::size_t targets) {
    sums_.assign(4 * targets, 0);
    more_ = &more;
    samples_.clear();
    next_sample_ = 0;
    const lanes::Counts counts =
        lanes::run(program_, *this, stacks_, sums_.data(), options_.instruction_set);
    statistics_.segments += counts.segments;
    statistics_.casts += counts.segments;
    statistics_.true_crossings += counts.true_crossings;
    statistics_.false_crossings += counts.false_crossings;
    statistics_.reflected_rays += counts.reflected;
    statistics_.refracted_rays += counts.refracted;
    statistics_.shadow_rays += counts.shadows;
    statistics_.deepest_level = std::max(statistics_.deepest_level, counts.deepest_level);
    statistics_.single_rays += counts.handed_over;
}

void LaneHost::more_rays(lanes::Stacks& stacks, std::size_t wanted) {
    for (; wanted > 0 && samples_at_hand() > 0; ++next_sample_) {
        const Sample& sample = samples_[next_sample_];
        const geom::Ray camera =
            camera_ray(scene_.source.camera, sample.x, sample.y, options_.width, options_.height);
        ++statistics_.camera_rays;
        const TracedRay start = tree_.events().start(camera, RayKind::image);
        lanes::WaitingRay ray;
        list_start(start, ray);
        if (is_tied(ray.inside)) {
            add_light(sample, tree_.radiance(start, sample.key));
            continue;
        }
        ray.origin = camera.origin;
        ray.direction = camera.direction;
        ray.throughput = Rgb{sample.weight};
        ray.code = sample.target;
        ray.key = sample.key;
        stacks.bin_of(ray.inside).push(ray);
        --wanted;
    }
}

std::size_t LaneHost::more_points(lanes::FilmPoints& points, std::size_t wanted) {
    const std::size_t count = std::min(wanted, samples_at_hand());
    for (std::size_t i = 0; i < count; ++i) {
        const Sample& sample = samples_[next_sample_ + i];
        points.x[i] = sample.x;
        points.y[i] = sample.y;
        points.weight[i] = sample.weight;
        points.pixel[i] = sample.target;
        points.key[i] = sample.key;
    }
    next_sample_ += count;
    statistics_.camera_rays += count;
    return count;
}

const scene::Interior& LaneHost::medium_at(int rank) const {
    if (rank < 0) return scene_.source.settings.outside;
    return medium(scene_,
                  scene_.parts[std::size_t(program_.members[std::size_t(rank)].part)].solid);
}

Vec3 LaneHost::sky(const Vec3& direction, int rank) {
    return tracer::sky(scene_.source, direction, medium_at(rank));
}

Vec3 LaneHost::transmittance(int rank, double way, bool of_shadow) {
    return tracer::transmittance(medium_at(rank), way, of_shadow);
}

/// What a surface with a texture leaves of a light behind it.
Rgb LaneHost::pass_shadow(const lanes::Surface& surface, lanes::RayStack& stack) {
    const Part& part = scene_.parts[std::size_t(surface.part)];
    if (part.is_opaque && !part.no_shadow) return Rgb{0.0};
    const scene::Texture& texture =
        scene_.source.textures[scene_.source.objects[std::size_t(part.object)].texture];
    lanes::WaitingRay on = surface.next(surface.ray.direction, true);
    if (!part.no_shadow) on.throughput *= evaluate(texture, surface.point).transparency();
    on.t_max = surface.ray.t_max - surface.t;
    if (scene::max_channel(on.throughput) != 0.0) stack.push(on);
    return Rgb{0.0};
}

Vec3 LaneHost::shade(const lanes::Surface& surface, lanes::Stacks& stacks) {
    if (surface.ray.code & lanes::RayCode::shadow) return pass_shadow(surface, stacks.shadows);

    const auto solid_at = [&](int rank) {
        return rank < 0 ? outside
                        : scene_.parts[std::size_t(program_.members[std::size_t(rank)].part)].solid;
    };
    Event event;
    event.t = surface.t;
    event.part = event.skin = surface.part;
    event.face = surface.face;
    event.normal = surface.normal;
    event.origin.origin = surface.point;
    event.solid_before = solid_at(surface.rank_before);
    event.solid_after = solid_at(surface.rank_after);
    const Vec3& direction = surface.ray.direction;
    const Rgb& throughput = surface.ray.throughput;
    tracer::shade(scene_, direction, event, surface.normal,
                  program_.whitted ? std::optional(program_.least_weight) : std::nullopt,
                  surface.ray.key, shading_);

    Rgb own = shading_.own;
    for (const LightTerm& term : shading_.lights) {
        if (term.distance == 0.0) {
            own += term.light;
            continue;
        }
        ++statistics_.shadow_rays;
        lanes::WaitingRay shadow = surface.next(term.direction, term.from_behind);
        shadow.throughput = throughput * term.light;
        shadow.t_max = term.distance;
        shadow.code |= lanes::RayCode::shadow;
        stacks.shadows.push(shadow);
    }

    const auto go_on = [&](const Vec3& towards, bool behind, const Rgb& share, double weight,
                           std::uint64_t key, bool straight, std::uint64_t& count) {
        lanes::WaitingRay ray = surface.next(towards, behind);
        ray.throughput = throughput * share;
        ray.weight = surface.ray.weight * weight;
        ray.key = key;
        if (ray.throughput == Rgb{0.0}) return;
        if (program_.sampled) {
            const double gain = lanes::survive(ray.weight, key);
            if (gain == 0.0) return;
            ray.throughput *= gain;
            ray.weight *= gain;
        }
        ++count;
        if (surface.level >= program_.most_levels || ray.weight < program_.least_weight) return;
        if (straight) ray.code |= lanes::RayCode::straight;
        if (!behind) ray.code |= lanes::RayCode::reflected;
        stacks.bin_of(ray.inside).push(ray);
    };
    const auto back = [&] { return mirrored(direction, surface.normal, shading_.normal); };
    const std::uint64_t key = surface.ray.key;
    if (shading_.total_reflection) {
        go_on(back(), false, Rgb{1.0}, scene::max_channel(shading_.through),
              lanes::reflected_key(key), false, statistics_.reflected_rays);
    } else {
        const bool mirror = shading_.mirror != Rgb{0.0}, through = shading_.transmitted.has_value();
        const double mirror_share = scene::max_channel(shading_.mirror),
                     through_share = scene::max_channel(shading_.through);
        const lanes::Branches branches = program_.sampled
                                             ? lanes::choose(mirror, mirror_share, through,
                                                             through_share, surface.ray.weight, key)
                                             : lanes::Branches{mirror, through, 1.0, 1.0};
        if (branches.mirror) {
            go_on(back(), false, branches.mirror_gain * shading_.mirror,
                  branches.mirror_gain * shading_.mirror_weight, lanes::reflected_key(key), false,
                  statistics_.reflected_rays);
        }
        if (branches.through) {
            go_on(*shading_.transmitted, true, branches.through_gain * shading_.through,
                  branches.through_gain * through_share, lanes::transmitted_key(key),
                  shading_.straight, statistics_.refracted_rays);
        }
    }
    return throughput * own;
}

void LaneHost::add_contacts(const lanes::WaitingRay& ray, TracedRay& traced) const {
    std::uint64_t triangles = ray.mesh_contacts;  // the last mesh's first
    for (std::size_t i = program_.solids.size(); i-- > 0;) {
        const lanes::Solid& solid = program_.solids[i];
        int face = int(ray.contacts >> (4 * i) & 15u) - 1;
        if (face < 0) continue;
        if (solid.kind == lanes::Kind::mesh) {
            face = int(triangles & 0xffffffffu) - 1;
            triangles >>= 32;
        } else if (face > 13) {  // a number that does not fit
            continue;
        }
        traced.contacts.push_back({solid.part, face, is_bit(ray.inside, solid.place)});
    }
    std::ranges::reverse(traced.contacts);
    for (const int shift : {0, 32}) {
        const int rank = int(ray.sphere_contacts >> shift & 0xffffffffu) - 1;
        if (rank >= 0)
            traced.contacts.push_back(
                {program_.members[std::size_t(rank)].part, 0, is_bit(ray.inside, rank)});
    }
}

Vec3 LaneHost::follow(const lanes::WaitingRay& ray) {
    RayTree::Pending pending;
    TracedRay& traced = pending.ray;
    traced.ray.origin = ray.origin;
    traced.ray.direction = ray.direction;
    traced.birth.magnitude = ray.birth_magnitude;
    for (std::size_t rank = 0; rank < program_.members.size(); ++rank) {
        if (is_bit(ray.inside, int(rank))) traced.interior.enter(program_.members[rank].part);
    }
    add_contacts(ray, traced);
    if (ray.code & lanes::RayCode::reflected) traced.kind = RayKind::reflection;
    if (ray.code & lanes::RayCode::shadow) {
        traced.kind = RayKind::shadow;
        return ray.throughput * tree_.unshadowed(std::move(traced), ray.t_max, ray.way_before);
    }
    pending.throughput = ray.throughput;
    pending.weight = ray.weight;
    pending.level = int((ray.code & lanes::RayCode::level_mask) >> lanes::RayCode::level_shift);
    pending.straight = pending.is_sure = (ray.code & lanes::RayCode::straight) != 0;
    pending.way_before = ray.way_before;
    pending.key = ray.key;
    return tree_.follow(std::move(pending));
}

}  // namespace meniscus::tracer
