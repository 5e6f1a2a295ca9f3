#include "compare/jump_regions.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "tracer/camera_rays.hpp"
#include "tracer/ray_tree.hpp"

namespace meniscus::compare {
namespace {

using geom::Vec2;
using scene::Rgb;

constexpr int halvings = 8;

double apart(const Rgb& a, const Rgb& b) {
    double largest = 0.0;
    for (int i = 0; i < 3; ++i)
        largest =
            std::max(largest, std::abs(std::clamp(a[i], 0.0, 1.0) - std::clamp(b[i], 0.0, 1.0)));
    return largest;
}

class ExactPicture {
public:
    ExactPicture(const tracer::RenderScene& scene, const tracer::Options& options)
        : scene_(scene), options_(options), tree_(scene, options, statistics_) {}

    /// In linear light, as a rendered picture; `place` in pixels from the top left.
    Rgb at(const Vec2& place) {
        const auto ray = tracer::camera_ray(scene_.source.camera, place.x, place.y, options_.width,
                                            options_.height);
        const Rgb numbers = tree_.radiance(ray, 0);
        const auto& space = scene_.source.settings.working_space;
        if (space.is_linear()) return numbers;
        return {space.to_light(numbers[0]), space.to_light(numbers[1]), space.to_light(numbers[2])};
    }
    /// Of the latest place: whether a medium lies behind the first surface.
    bool is_inside() const { return tree_.first_hit.medium != tracer::outside; }

    bool jumps(Vec2 a, Rgb at_a, Vec2 b) {
        Rgb at_b = at(b);
        for (int i = 0; i < halvings && apart(at_a, at_b) > least_jump; ++i) {
            const Vec2 middle = 0.5 * (a + b);
            const Rgb color = at(middle);
            if (apart(at_a, color) > apart(color, at_b)) {
                b = middle;
                at_b = color;
            } else {
                a = middle;
                at_a = color;
            }
        }
        return apart(at_a, at_b) > least_jump;
    }

private:
    const tracer::RenderScene& scene_;
    const tracer::Options& options_;
    tracer::Statistics statistics_;
    tracer::RayTree tree_;
};

constexpr Vec2 half_pixels[] = {{-0.5, 0.0}, {0.5, 0.0}, {0.0, -0.5}, {0.0, 0.5}};

}  // namespace

Regions regions_by_jumps(const tracer::RenderScene& scene, const tracer::Options& options,
                         const image::Image& picture) {
    // A char each: rows are written side by side.
    std::vector<char> is_edge(std::size_t(options.width) * std::size_t(options.height));
    auto is_inside = is_edge;
    tbb::parallel_for(0, options.height, [&](int y) {
        ExactPicture exact(scene, options);
        for (int x = 0; x < options.width; ++x) {
            const std::size_t pixel = std::size_t(y) * std::size_t(options.width) + std::size_t(x);
            const Vec2 centre{x + 0.5, y + 0.5};
            exact.at(centre);
            is_inside[pixel] = exact.is_inside();
            const float* rgb = picture.pixel(x, y);
            const Rgb color{rgb[0], rgb[1], rgb[2]};
            is_edge[pixel] = std::ranges::any_of(half_pixels, [&](const Vec2& step) {
                return exact.jumps(centre, color, centre + step);
            });
        }
    });
    return regions_of(
        {is_inside.begin(), is_inside.end()}, {is_edge.begin(), is_edge.end()},
        fmt::format("by our own picture: inside glass where a medium lies behind the first "
                    "surface; edges where it jumps by more than {} within half a pixel of the "
                    "pixel's centre",
                    least_jump));
}

}  // namespace meniscus::compare
