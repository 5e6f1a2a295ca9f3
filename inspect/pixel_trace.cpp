#include "inspect/pixel_trace.hpp"

#include "tracer/attenuation.hpp"
#include "tracer/camera_rays.hpp"

namespace meniscus::inspect {
namespace {

using tracer::TreeNode;

Segment make_segment(const tracer::RenderScene& scene, const Names& names, const TreeNode& node,
                     const std::vector<Segment>& before, tracer::InteriorMode mode) {
    Segment segment;
    segment.node = node;
    segment.start = listing(scene, node.start.interior);
    segment.steps = replay(scene, names, node, mode);
    const Segment* parent = node.parent < 0 ? nullptr : &before[std::size_t(node.parent)];
    if (parent) segment.nesting = parent->nesting + 1;

    if (segment.ends_at_surface()) {
        // A way goes on through a boundary of like media.
        const bool goes_on = parent && !parent->node.is_surface;
        segment.way = node.event.t + (goes_on ? parent->way : 0.0);
        if (node.is_surface) {
            const auto& around = tracer::medium(scene, node.event.solid_before);
            segment.absorption = tracer::transmittance(around, segment.way);
        }
    }
    segment.adds = node.throughput * segment.absorption * node.own_color;
    return segment;
}

}  // namespace

PixelTrace trace_ray(const tracer::RenderScene& scene, const Names& names,
                     const tracer::Options& options, const geom::Ray& ray) {
    tracer::Statistics statistics;
    tracer::RayTree ray_tree(scene, options, statistics);
    tracer::TreeRecord record;
    ray_tree.record = &record;

    PixelTrace trace;
    trace.width = options.width;
    trace.height = options.height;
    trace.tree = tracer::implied_tree(options);
    trace.interior = options.interior;
    trace.color = ray_tree.radiance(ray, tracer::mix(options.seed));
    const auto& space = scene.source.settings.working_space;
    for (int i = 0; i < 3; ++i) trace.light[i] = space.to_light(trace.color[i]);
    trace.leaks = statistics.leaks;
    for (const TreeNode& node : record) {
        trace.segments.push_back(
            make_segment(scene, names, node, trace.segments, options.interior));
    }
    return trace;
}

PixelTrace trace_pixel(const tracer::RenderScene& scene, const Names& names,
                       const tracer::Options& options, int x, int y) {
    const geom::Ray ray =
        tracer::camera_ray(scene.source.camera, x + 0.5, y + 0.5, options.width, options.height);
    PixelTrace trace = trace_ray(scene, names, options, ray);
    trace.x = x;
    trace.y = y;
    return trace;
}

}  // namespace meniscus::inspect
