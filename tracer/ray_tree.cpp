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
    step(first, sum);
    while (stack_.size() > floor) {
        Pending pending = std::move(stack_.back());
        stack_.pop_back();
        step(pending, sum);
    }
    return sum;
}

bool RayTree::is_cut(int level, double weight) const {
    return level >= max_level_ || weight < min_weight_;
}

int RayTree::begin_node(const Pending& start) {
    if (!record) return -1;
    TreeNode& entry = record->emplace_back();
    entry.parent = start.parent;
    entry.branch = start.branch;
    entry.start = start.ray;
    entry.level = start.level;
    entry.weight = start.weight;
    entry.throughput = start.throughput;
    return int(record->size()) - 1;
}

void RayTree::step(Pending& pending, Rgb& sum) {
    int node = begin_node(pending);
    if (!pending.is_sure && is_cut(pending.level, pending.weight)) {
        if (record) {
            record->at(node).end =
                pending.level >= max_level_ ? TreeNode::End::depth : TreeNode::End::weight;
        }
        return;
    }
    if (!pending.straight) ++pending.level;
    statistics_.deepest_level = std::max(statistics_.deepest_level, pending.level);

    Event event;
    while (true) {
        std::vector<Judged> judged;
        if (record) finder_.record = &judged;
        const bool is_met = finder_.next(pending.ray, geom::infinity, event);
        finder_.record = nullptr;
        if (record) record->at(node).crossings = std::move(judged);

        // The segment ran in one medium: that of the top of its list, which false crossings do not
        // change.
        if (!is_met) {
            const Rgb light = sky(scene_.source, pending.ray.ray.direction,
                                  medium(scene_, pending.ray.interior.top_solid(scene_)));
            if (record) record->at(node).own_color = light;
            sum += pending.throughput * light;
            return;
        }
        const scene::Interior& around = medium(scene_, event.solid_before);
        const scene::Interior& behind = medium(scene_, event.solid_after);
        const scene::Texture& texture =
            scene_.source.textures[scene_.source.objects[scene_.parts[event.skin].object].texture];
        const double way = pending.way_before + event.t;
        const bool alike = scene_.parts[event.part].is_member && around.same_medium(behind);
        if (record) {
            TreeNode& entry = record->at(node);
            entry.end = TreeNode::End::surface;
            entry.event = event;
            entry.ior_before = around.ior;
            entry.ior_after = behind.ior;
            entry.angle_degrees = glm::degrees(std::acos(
                std::min(1.0, std::abs(glm::dot(pending.ray.ray.direction, event.normal)))));
        }
        if (alike && texture.clear) {
            // Nothing is there to see: go on in the same medium, which fades on from where it was.
            if (record) record->at(node).is_surface = false;
            go_straight_on(pending, event, node);
            pending.way_before = way;
            node = begin_node(pending);
            continue;
        }
        if (pending.level == 1 && first_hit.object < 0) {
            const Part& part = scene_.parts[event.part];
            first_hit = {way, event.normal, part.object,
                         part.is_opaque ? outside : event.solid_after};
        }
        if (around.attenuates()) pending.throughput *= transmittance(around, way);
        if (texture.clear) {
            shade_clear(pending, event, node);
        } else {
            shade_textured(pending, event, node, sum);
        }
        return;
    }
}

/// The same ray behind an event that bends nothing.
void RayTree::go_straight_on(Pending& pending, const Event& event, int node) const {
    const Vec3 direction = pending.ray.ray.direction;
    pending.ray.ray = event.origin;
    pending.ray.ray.direction = direction;
    pending.ray.interior = event.after;
    pending.ray.contacts = event.contacts;
    for (Contact& contact : pending.ray.contacts) contact.starts_inside = !contact.starts_inside;
    pending.ray.birth = event.birth;
    pending.straight = true;
    pending.parent = node;
    pending.branch = TreeNode::Branch::straight;
}

void RayTree::branch(const Pending& parent, const Event& event, int node, const Way& mirror,
                     const Way& through) {
    lanes::Branches branches{mirror.exists, through.exists, 1.0, 1.0};
    if (tree_ == Tree::sampled) {
        branches = lanes::choose(mirror.exists, scene::max_channel(mirror.share), through.exists,
                                 scene::max_channel(through.share), parent.weight, parent.key);
    }
    if (branches.mirror)
        push(parent, event, node, mirror, TreeNode::Branch::reflected, branches.mirror_gain);
    if (branches.through) {
        push(parent, event, node, through,
             through.straight ? TreeNode::Branch::straight : TreeNode::Branch::refracted,
             branches.through_gain);
    }
}

std::uint64_t RayTree::key_of(TreeNode::Branch kind, const Pending& parent) {
    return kind == TreeNode::Branch::reflected ? lanes::reflected_key(parent.key)
                                               : lanes::transmitted_key(parent.key);
}

/// A new ray, made where it waits: there are many of them, and they are large.
void RayTree::push(const Pending& parent, const Event& event, int node, const Way& way,
                   TreeNode::Branch kind, double gain) {
    Rgb throughput = parent.throughput * gain * way.share;
    double weight = parent.weight * (way.weight * gain);
    if (throughput == Rgb{0.0}) return;
    if (tree_ == Tree::sampled) {
        const double survival = lanes::survive(weight, key_of(kind, parent));
        if (survival == 0.0) return;
        throughput *= survival;
        weight *= survival;
    }
    ++(kind == TreeNode::Branch::reflected ? statistics_.reflected_rays
                                           : statistics_.refracted_rays);
    if (is_cut(parent.level, weight) && !record) return;
    Pending& child = stack_.emplace_back();
    start(parent, event, node, way, kind, child);
    child.throughput = throughput;
    child.weight = weight;
}

/// All but its light and its weight.
void RayTree::start(const Pending& parent, const Event& event, int node, const Way& way,
                    TreeNode::Branch kind, Pending& child) {
    const bool is_reflected = kind == TreeNode::Branch::reflected;
    child.ray.ray = event.origin;
    child.ray.ray.direction = way.direction;
    child.ray.interior = is_reflected ? event.before : event.after;
    child.ray.contacts = event.contacts;
    if (!is_reflected) {
        for (Contact& contact : child.ray.contacts) contact.starts_inside = !contact.starts_inside;
    }
    child.ray.birth = event.birth;
    child.ray.kind = parent.ray.kind;
    if (is_reflected) finder_.become(child.ray, RayKind::reflection);
    child.level = parent.level;
    child.straight = way.straight;
    child.key = key_of(kind, parent);
    child.parent = node;
    child.branch = kind;
}

/// The boundary of two media and nothing else: exact Fresnel reflection and refraction, energy
/// conserved.
void RayTree::shade_clear(const Pending& pending, const Event& event, int node) {
    const Vec3& direction = pending.ray.ray.direction;
    Vec3 normal = event.shading_normal;
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
    Way mirror, through;
    if (reflectance > 0.0) {
        mirror = {true, false, mirrored(direction, event.normal, normal), Rgb{reflectance},
                  reflectance};
    }
    if (transmittance > (tree_ == Tree::whitted ? min_weight_ : 0.0)) {
        const bool straight = std::abs(eta - 1.0) < 1e-10;
        const std::optional<Vec3> refracted =
            straight ? std::optional<Vec3>(direction) : refract(direction, normal, eta);
        if (refracted) through = {true, straight, *refracted, Rgb{transmittance}, transmittance};
    }
    branch(pending, event, node, mirror, through);
}

}  // namespace meniscus::tracer
