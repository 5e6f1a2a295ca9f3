#include "povray/scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace meniscus::povray {
namespace {

/// In sizes of the scene: what lies nearer to the horizon than the inverse is lost.
constexpr double least_view = 300.0;
/// The same where a medium has no end: a ray that POV-Ray loses in it never comes out.
constexpr double least_view_in_a_medium = 3e3;
/// An overlap of this part of the scene's size is seen.
constexpr double largest_overlap = 1e-5;

double size_of(const tracer::RenderScene& scene) {
    geom::Bounds box = scene.bvh.bounds();
    box.extend(scene.source.camera.location);
    const double size = geom::max_abs(box.size());
    return size > 0.0 ? size : 1.0;
}

bool has_no_end(const tracer::Part& part) { return !part.shape.bounds().is_finite(); }
bool is_medium_without_end(const tracer::Part& part) { return part.is_member && has_no_end(part); }

double round_up(double scale) { return std::pow(10.0, std::ceil(std::log10(scale) - 1e-9)); }
double round_down(double scale) { return std::pow(10.0, std::floor(std::log10(scale) + 1e-9)); }

}  // namespace

double natural_scale(const tracer::RenderScene& scene, const ExportOptions& options) {
    const double size = size_of(scene);
    const bool is_small =
        options.model == Model::contact && std::ranges::none_of(scene.parts, is_medium_without_end);
    double scale = std::pow(10.0, std::round(std::log10((is_small ? 1e4 : 1e3) / size)));
    if (options.model == Model::gap && options.gap > 0.0)
        scale = std::max(scale, round_up(2.0 * nearest / options.gap));
    return scale;
}

std::vector<std::string> scale_warnings(const tracer::RenderScene& scene,
                                        const ExportOptions& options, double scale) {
    std::vector<std::string> warnings;
    const double size = size_of(scene), view = farthest / scale;
    if (const double overlap = least_overlap / scale;
        options.model == Model::contact && overlap > largest_overlap * size) {
        warnings.push_back(
            fmt::format("solids overlap by {:.2g} at --scale {:g}, for POV-Ray to see it: large "
                        "enough to be seen in the "
                        "picture; use --scale {:g} or more",
                        overlap, scale, round_up(least_overlap / (largest_overlap * size))));
    }
    if (options.model == Model::gap && options.gap > 0.0 && options.gap * scale < nearest) {
        warnings.push_back(fmt::format(
            "at --scale {:g} POV-Ray sees no film thinner than {:.2g} in the light (shadow rays) "
            "and {:.2g} otherwise; "
            "use --scale {:g} or more",
            scale, nearest / scale, 0.1 * nearest / scale, round_up(nearest / options.gap)));
    }
    const bool ends = std::ranges::none_of(scene.parts, has_no_end);
    const bool media_end = std::ranges::none_of(scene.parts, is_medium_without_end);
    const double least = size * (ends ? 1.0 : media_end ? least_view : least_view_in_a_medium);
    if (view < least) {
        warnings.push_back(fmt::format(
            "at --scale {:g} POV-Ray sees nothing farther than {:.2g}; use --scale {:g} or less",
            scale, view, round_down(farthest / least)));
    }
    return warnings;
}

}  // namespace meniscus::povray
