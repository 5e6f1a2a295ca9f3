#include "tracer/ray_tree.hpp"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "lanes/chance.hpp"
#include "tracer/attenuation.hpp"
#include "tracer/fresnel.hpp"
#include "tracer/shading.hpp"
#include "tracer/sky.hpp"

namespace meniscus::tracer {

using geom::Vec3;
using scene::Rgb;

RayTree::RayTree(const RenderScene& scene, const Options& options, Statistics& statistics)
    : scene_(scene),
      options_(options),
      statistics_(statistics),
      finder_(scene, options, statistics),
      tree_(implied_tree(options)) {
    const scene::Settings& settings = scene.source.settings;
    const bool whitted = tree_ == Tree::whitted;
    max_level_ = whitted ? settings.max_trace_level.value_or(5) : options.depth;
    min_weight_ = whitted               ? settings.adc_bailout.value_or(1.0 / 255.0)
                  : tree_ == Tree::full ? options.cutoff
                                        : 0.0;
}

scene::Rgb RayTree::radiance(const geom::Ray& camera_ray, std::uint64_t key) {
    ++statistics_.camera_rays;
    return radiance(finder_.start(camera_ray, RayKind::image), key);
}

scene::Rgb RayTree::radiance(const TracedRay& ray, std::uint64_t key) {
    first_hit = {};
    Pending first;
    first.ray = ray;
    first.key = key;
    return follow(std::move(first));
}

/// Works the stack off down to where it stood: a call within a call (POV-Ray's reflection exponent)
/// leaves the rest alone.
scene::Rgb RayTree::follow(Pending first) {
    Rgb sum{0.0};
    const std::size_t floor = stack_.size();
    stack_.push_back(std::move(first));
    while (stack_.size() > floor) {
        Pending pending = std::move(stack_.back());
        stack_.pop_back();
        step(std::move(pending), sum);
    }
    return sum;
}

bool RayTree::is_cut(const Pending& pending) const {
    return pending.level >= max_level_ || pending.weight < min_weight_;
}

void RayTree::step(Pending pending, Rgb& sum) {
    int node = -1;
    const auto begin_node = [&](const Pending& start) {
        if (!record) return;
        node = int(record->size());
        TreeNode& entry = record->emplace_back();
        entry.parent = start.parent;
        entry.branch = start.branch;
        entry.start = start.ray;
        entry.level = start.level;
        entry.weight = start.weight;
        entry.throughput = start.throughput;
    };
    begin_node(pending);
    if (is_cut(pending)) {
        if (record) {
            record->at(node).end =
                pending.level >= max_level_ ? TreeNode::End::depth : TreeNode::End::weight;
        }
        return;
    }
    if (!pending.straight) ++pending.level;
    statistics_.deepest_level = std::max(statistics_.deepest_level, pending.level);

    while (true) {
        std::vector<Judged> judged;
        if (record) finder_.record = &judged;
        const std::optional<Event> event = finder_.next(pending.ray);
        finder_.record = nullptr;
        if (record) record->at(node).crossings = std::move(judged);

        // The segment ran in one medium: that of the top of its list, which false crossings do not
        // change.
        const int solid = event ? event->solid_before : pending.ray.interior.top_solid(scene_);
        const scene::Interior& around = medium(scene_, solid);
        if (!event) {
            const Rgb light = sky(scene_.source, pending.ray.ray.direction, around);
            if (record) record->at(node).own_color = light;
            sum += pending.throughput * light;
            return;
        }
        const scene::Texture& texture =
            scene_.source.textures[scene_.source.objects[scene_.parts[event->skin].object].texture];
        const scene::Interior& behind = medium(scene_, event->solid_after);
        const double way = pending.way_before + event->t;
        const bool alike = scene_.parts[event->part].is_member && around.same_medium(behind);
        if (record) {
            TreeNode& entry = record->at(node);
            entry.end = TreeNode::End::surface;
            entry.event = *event;
            entry.ior_before = around.ior;
            entry.ior_after = behind.ior;
            entry.angle_degrees = glm::degrees(std::acos(
                std::min(1.0, std::abs(glm::dot(pending.ray.ray.direction, event->normal)))));
        }
        if (alike && texture.clear) {
            // Nothing is there to see: go on in the same medium, which fades on from where it was.
            if (record) record->at(node).is_surface = false;
            Pending on = transmitted(pending, *event, pending.ray.ray.direction, true, node);
            on.key = pending.key;
            on.way_before = way;
            pending = std::move(on);
            begin_node(pending);
            continue;
        }
        if (pending.level == 1 && first_hit.object < 0) {
            const Part& part = scene_.parts[event->part];
            first_hit = {way, event->normal, part.object,
                         part.is_opaque ? outside : event->solid_after};
        }
        if (around.attenuates()) pending.throughput *= transmittance(around, way);
        if (texture.clear) {
            shade_clear(pending, *event, node);
        } else {
            shade_textured(pending, *event, node, sum);
        }
        return;
    }
}

RayTree::Pending RayTree::reflected(const Pending& parent, const Event& event,
                                    const Vec3& shading_normal, int node) const {
    Pending child;
    child.ray.ray = event.origin;
    child.ray.ray.direction = mirrored(parent.ray.ray.direction, event.normal, shading_normal);
    child.ray.interior = event.before;
    child.ray.contacts = event.contacts;
    child.ray.birth = event.birth;
    child.ray.kind = RayKind::reflection;
    child.throughput = parent.throughput;
    child.weight = parent.weight;
    child.level = parent.level;
    child.key = lanes::reflected_key(parent.key);
    child.parent = node;
    child.branch = TreeNode::Branch::reflected;
    return child;
}

RayTree::Pending RayTree::transmitted(const Pending& parent, const Event& event,
                                      const Vec3& direction, bool straight, int node) const {
    Pending child;
    child.ray.ray = event.origin;
    child.ray.ray.direction = direction;
    child.ray.interior = event.after;
    child.ray.contacts = event.contacts;
    for (Contact& contact : child.ray.contacts) contact.starts_inside = !contact.starts_inside;
    child.ray.birth = event.birth;
    child.ray.kind = parent.ray.kind;
    child.throughput = parent.throughput;
    child.weight = parent.weight;
    child.level = parent.level;
    child.key = lanes::transmitted_key(parent.key);
    child.straight = straight;
    child.parent = node;
    child.branch = straight ? TreeNode::Branch::straight : TreeNode::Branch::refracted;
    return child;
}

void RayTree::branch(Pending& parent, std::optional<Pending> reflected, const Rgb& reflectance,
                     double reflected_weight, std::optional<Pending> transmitted,
                     const Rgb& transmittance, double transmitted_weight) {
    if (tree_ == Tree::sampled) {
        const lanes::Branches branches = lanes::choose(
            reflected.has_value(), scene::max_channel(reflectance), transmitted.has_value(),
            scene::max_channel(transmittance), parent.weight, parent.key);
        if (!branches.mirror) reflected.reset();
        if (!branches.through) transmitted.reset();
        if (reflected) reflected->throughput *= branches.mirror_gain;
        if (transmitted) transmitted->throughput *= branches.through_gain;
        reflected_weight *= branches.mirror_gain;
        transmitted_weight *= branches.through_gain;
    }
    const auto push = [&](Pending& child, const Rgb& factor, double weight) {
        child.throughput *= factor;
        child.weight *= weight;
        if (child.throughput == Rgb{0.0}) return;
        if (tree_ == Tree::sampled) {
            const double gain = lanes::survive(child.weight, child.key);
            if (gain == 0.0) return;
            child.throughput *= gain;
            child.weight *= gain;
        }
        if (child.branch == TreeNode::Branch::reflected) {
            ++statistics_.reflected_rays;
        } else {
            ++statistics_.refracted_rays;
        }
        stack_.push_back(std::move(child));
    };
    if (reflected) push(*reflected, reflectance, reflected_weight);
    if (transmitted) push(*transmitted, transmittance, transmitted_weight);
}

/// The boundary of two media and nothing else: exact Fresnel reflection and refraction, energy
/// conserved.
void RayTree::shade_clear(Pending& pending, const Event& event, int node) {
    const Vec3& direction = pending.ray.ray.direction;
    const Part& part = scene_.parts[event.part];
    Vec3 normal = part.shape.shading_normal(event.face, event.origin);
    if (glm::dot(normal, direction) > 0.0) normal = -normal;
    const double eta =
        medium(scene_, event.solid_before).ior / medium(scene_, event.solid_after).ior;
    const double reflectance =
        fresnel_reflectance(eta, std::min(1.0, -glm::dot(normal, direction)));
    const double transmittance = 1.0 - reflectance;
    if (record) {
        TreeNode& entry = record->at(node);
        entry.reflectance = Rgb{reflectance};
        entry.transmittance = Rgb{transmittance};
        entry.total_reflection = reflectance == 1.0;
    }
    std::optional<Pending> mirror, through;
    if (reflectance > 0.0) mirror = reflected(pending, event, normal, node);
    if (transmittance > (tree_ == Tree::whitted ? min_weight_ : 0.0)) {
        const bool straight = std::abs(eta - 1.0) < 1e-10;
        const std::optional<Vec3> refracted =
            straight ? std::optional<Vec3>(direction) : refract(direction, normal, eta);
        if (refracted) through = transmitted(pending, event, *refracted, straight, node);
    }
    branch(pending, std::move(mirror), Rgb{reflectance}, reflectance, std::move(through),
           Rgb{transmittance}, transmittance);
}

}  // namespace meniscus::tracer
