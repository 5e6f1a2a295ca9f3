#include "compare/jump_regions.hpp"

#include <fmt/format.h>

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

    /// `place` in pixels from the top left.
    Rgb at(const Vec2& place) {
        const auto ray = tracer::camera_ray(scene_.source.camera, place.x, place.y, options_.width,
                                            options_.height);
        return tree_.radiance(ray, 0);
    }
    /// Of the latest place: whether a medium lies behind the first surface.
    bool is_inside() const { return tree_.first_hit.medium != tracer::outside; }

    bool jumps(Vec2 a, Rgb at_a, Vec2 b, Rgb at_b) {
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

}  // namespace

Regions regions_by_jumps(const tracer::RenderScene& scene, const tracer::Options& options,
                         const image::Image& picture) {
    ExactPicture exact(scene, options);
    const std::size_t width = std::size_t(options.width), height = std::size_t(options.height);
    std::vector<bool> is_edge(width * height), is_inside(width * height);
    const auto color = [&](std::size_t x, std::size_t y) {
        const float* rgb = picture.pixel(int(x), int(y));
        return Rgb{rgb[0], rgb[1], rgb[2]};
    };
    const auto centre = [](std::size_t x, std::size_t y) {
        return Vec2{double(x) + 0.5, double(y) + 0.5};
    };
    const auto compare = [&](std::size_t x, std::size_t y, std::size_t u, std::size_t v) {
        const std::size_t a = y * width + x, b = v * width + u;
        if (is_edge[a] && is_edge[b]) return;
        if (exact.jumps(centre(x, y), color(x, y), centre(u, v), color(u, v)))
            is_edge[a] = is_edge[b] = true;
    };
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            exact.at(centre(x, y));
            is_inside[y * width + x] = exact.is_inside();
            if (x > 0) compare(x, y, x - 1, y);
            if (y > 0) compare(x, y, x, y - 1);
        }
    }
    return regions_of(
        is_inside, is_edge,
        fmt::format(
            "by our own picture: inside glass where a medium lies behind the first surface; "
            "edges are pixels between which and a neighbour the picture jumps by more than {}",
            least_jump));
}

}  // namespace meniscus::compare
