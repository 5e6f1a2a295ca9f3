#pragma once

#include <string>
#include <vector>

#include "tracer/next_event.hpp"
#include "tracer/sampler.hpp"
#include "tracer/shading.hpp"

namespace meniscus::tracer {

/// One segment of a recorded ray tree, for `inspect`.
struct TreeNode {
    enum class Branch { camera, reflected, refracted, straight };
    enum class End { surface, escape, depth, weight };

    int parent = -1;  // index of the node whose event made this ray
    Branch branch = Branch::camera;
    TracedRay start;
    int level = 0;
    double weight = 1.0;
    scene::Rgb throughput{1.0};  // at the start
    std::vector<Judged> crossings;
    End end = End::escape;
    Event event;  // if `end` is surface
    double ior_before = 1.0, ior_after = 1.0;
    double angle_degrees = 0.0;  // of incidence
    scene::Rgb reflectance{0.0}, transmittance{0.0};
    bool total_reflection = false;
    bool is_surface = true;     // false: alike media under a clear skin, nothing to see
    scene::Rgb own_color{0.0};  // the surface's own light, or the sky's, before throughput
};
using TreeRecord = std::vector<TreeNode>;

/// What a camera ray met first, for image layers.
struct FirstHit {
    double distance = 0.0;  // 0: nothing
    geom::Vec3 normal{0.0};
    int object = -1;
    int medium = outside;  // the solid whose medium lies behind it
};

/// Follows ray trees: scene to light along one camera ray. One for each thread.
class RayTree {
public:
    RayTree(const RenderScene& scene, const Options& options, Statistics& statistics);

    /// The light that comes back along a camera ray. What chance decides (in Tree::sampled only) is
    /// a function of `key`.
    scene::Rgb radiance(const geom::Ray& camera_ray, std::uint64_t key);
    /// The same, for a ray that starts with a list.
    scene::Rgb radiance(const TracedRay& ray, std::uint64_t key);

    EventFinder& events() { return finder_; }
    FirstHit first_hit;            // of the latest radiance()
    TreeRecord* record = nullptr;  // where to write the tree down, if anyone wants it

    /// A ray that waits for its turn.
    struct Pending {
        TracedRay ray;
        scene::Rgb throughput{1.0};
        double weight = 1.0;    // POV-Ray's adc weight: specular factors only
        int level = 0;          // surfaces behind it, as max_trace_level counts
        bool straight = false;  // goes straight on through a surface that bends nothing: uses up no
                                // level of its own
        bool is_sure = false;   // that it is followed, whatever its level, has been decided
        double way_before =
            0.0;  // scene units already covered in this medium since the last surface
        int parent = -1;
        std::uint64_t key = 0;  // what chance decides about it is a function of this
        TreeNode::Branch branch = TreeNode::Branch::camera;
    };

    /// The light of a ray and of all that comes of it, times its throughput.
    scene::Rgb follow(Pending first);
    /// What is left of a light at `distance` after the solids on the way: straight on, through the
    /// true crossings only. Zero behind anything opaque. `way` scene units in the medium lie behind
    /// the ray.
    scene::Rgb unshadowed(TracedRay shadow, double distance, double way = 0.0);

private:
    /// Where the light of a branch comes from, and how much of it.
    struct Way {
        bool exists = false;
        bool straight = false;
        geom::Vec3 direction{0.0};
        scene::Rgb share{0.0};
        double weight = 0.0;  // as a share of the parent's
    };

    int begin_node(const Pending& start);
    void step(Pending& pending, scene::Rgb& sum);
    void shade_clear(const Pending& pending, const Event& event, int node);
    void shade_textured(const Pending& pending, const Event& event, int node, scene::Rgb& sum);
    void go_straight_on(Pending& pending, const Event& event, int node) const;

    bool is_cut(int level, double weight) const;
    /// Puts what goes on into the stack: both branches, or in Tree::sampled one of them by chance
    /// where the weight is low.
    void branch(const Pending& parent, const Event& event, int node, const Way& mirror,
                const Way& through);
    void push(const Pending& parent, const Event& event, int node, const Way& way,
              TreeNode::Branch kind, double gain);
    void start(const Pending& parent, const Event& event, int node, const Way& way,
               TreeNode::Branch kind, Pending& child);
    static std::uint64_t key_of(TreeNode::Branch kind, const Pending& parent);

    const RenderScene& scene_;
    const Options& options_;
    Statistics& statistics_;
    EventFinder finder_;
    std::vector<Pending> stack_;
    std::vector<LightTerm> spare_lights_;
    Tree tree_;
    int max_level_;
    double min_weight_;
};

}  // namespace meniscus::tracer
