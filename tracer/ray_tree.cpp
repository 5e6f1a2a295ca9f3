#include "tracer/ray_tree.hpp"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "tracer/attenuation.hpp"
#include "tracer/fresnel.hpp"
#include "tracer/pigment.hpp"

namespace meniscus::tracer {
namespace {

using geom::Vec3;
using scene::Rgb;

double max_channel(const Rgb& c) { return std::max({c.r, c.g, c.b}); }

/// Below this weight Tree::sampled follows one branch by chance instead of both.
constexpr double split_above = 0.35;
/// Below this weight Tree::sampled lets a path survive by chance.
constexpr double roulette_below = 0.02;

}  // namespace

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

scene::Rgb RayTree::radiance(const geom::Ray& camera_ray, RandomStream& random) {
    ++statistics_.camera_rays;
    return radiance(finder_.start(camera_ray, RayKind::image), random);
}

scene::Rgb RayTree::radiance(const TracedRay& ray, RandomStream& random) {
    first_hit = {};
    Pending first;
    first.ray = ray;
    return follow(std::move(first), random);
}

/// Works the stack off down to where it stood: a call within a call (POV-Ray's reflection exponent)
/// leaves the rest alone.
scene::Rgb RayTree::follow(Pending first, RandomStream& random) {
    Rgb sum{0.0};
    const std::size_t floor = stack_.size();
    stack_.push_back(std::move(first));
    while (stack_.size() > floor) {
        Pending pending = std::move(stack_.back());
        stack_.pop_back();
        step(std::move(pending), random, sum);
    }
    return sum;
}

bool RayTree::is_cut(const Pending& pending) const {
    return pending.level >= max_level_ || pending.weight < min_weight_;
}

void RayTree::step(Pending pending, RandomStream& random, Rgb& sum) {
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
            const Rgb light = sky(pending.ray.ray.direction, around);
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
            shade_clear(pending, *event, node, random);
        } else {
            shade_textured(pending, *event, node, random, sum);
        }
        return;
    }
}

RayTree::Pending RayTree::reflected(const Pending& parent, const Event& event,
                                    const Vec3& shading_normal, int node) const {
    Pending child;
    const Vec3& direction = parent.ray.ray.direction;
    Vec3 mirrored = reflect(direction, shading_normal);
    // A smooth normal may send the ray below the real surface: it is reflected there once more, as
    // POV-Ray does.
    const Vec3 raw = glm::dot(event.normal, direction) < 0.0 ? event.normal : -event.normal;
    const double below = glm::dot(mirrored, raw);
    if (below < 0.0 && shading_normal != event.normal)
        mirrored = glm::normalize(mirrored - 2.0 * below * raw);
    child.ray.ray = event.origin;
    child.ray.ray.direction = mirrored;
    child.ray.interior = event.before;
    child.ray.contacts = event.contacts;
    child.ray.birth_magnitude = event.magnitude;
    child.ray.kind = RayKind::reflection;
    child.throughput = parent.throughput;
    child.weight = parent.weight;
    child.level = parent.level;
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
    child.ray.birth_magnitude = event.magnitude;
    child.ray.kind = parent.ray.kind;
    child.throughput = parent.throughput;
    child.weight = parent.weight;
    child.level = parent.level;
    child.straight = straight;
    child.parent = node;
    child.branch = straight ? TreeNode::Branch::straight : TreeNode::Branch::refracted;
    return child;
}

void RayTree::branch(Pending& parent, std::optional<Pending> reflected, const Rgb& reflectance,
                     double reflected_weight, std::optional<Pending> transmitted,
                     const Rgb& transmittance, double transmitted_weight, RandomStream& random) {
    if (tree_ == Tree::sampled && parent.weight < split_above && reflected && transmitted) {
        // One of the two, with the probability of its share: what goes on keeps the sum of their
        // weights.
        const double r = max_channel(reflectance), t = max_channel(transmittance);
        if (r + t > 0.0) {
            const double p = r / (r + t);
            if (random.next() < p) {
                reflected->throughput /= p;
                reflected_weight /= p;
                transmitted.reset();
            } else {
                transmitted->throughput /= 1.0 - p;
                transmitted_weight /= 1.0 - p;
                reflected.reset();
            }
        }
    }
    const auto push = [&](Pending& child, const Rgb& factor, double weight) {
        child.throughput *= factor;
        child.weight *= weight;
        if (child.throughput == Rgb{0.0}) return;
        if (tree_ == Tree::sampled && child.weight < roulette_below) {
            const double survival = std::max(child.weight / roulette_below, 0.05);
            if (random.next() >= survival) return;
            child.throughput /= survival;
            child.weight /= survival;
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
void RayTree::shade_clear(Pending& pending, const Event& event, int node, RandomStream& random) {
    const Vec3& direction = pending.ray.ray.direction;
    const Part& part = scene_.parts[event.part];
    Vec3 normal = part.shape.shading_normal(event.face, event.origin.origin);
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
           Rgb{transmittance}, transmittance, random);
}

/// The sky is at infinity: a medium out there that absorbs leaves nothing of it.
scene::Rgb RayTree::sky(const Vec3& direction, const scene::Interior& around) const {
    const scene::Scene& scene = scene_.source;
    Rgb light = scene.background.rgb;
    for (const scene::Pigment& pigment : scene.sky_sphere.pigments) {
        const scene::Color color = evaluate(pigment, direction);
        light =
            scene.sky_sphere.emission * color.opacity() * color.rgb + color.transparency() * light;
    }
    for (int i = 0; i < 3; ++i) {
        if (around.absorption[i] > 0.0) light[i] = 0.0;
        if (!around.fade.is_active()) continue;
        const double left = around.fade.color[i];
        if (around.fade.power >= 1000.0) {
            if (left < 1.0) light[i] = 0.0;
        } else {
            light[i] *= around.fade.power == 0.0 ? 0.5 * (1.0 + left) : left;
        }
    }
    return light;
}

}  // namespace meniscus::tracer
