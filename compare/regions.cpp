#include "compare/regions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace meniscus::compare {
namespace {

/// True where `unlike(pixel, neighbour)` holds for one of the eight neighbours.
template <class Unlike>
std::vector<bool> edges(int width, int height, Unlike unlike) {
    std::vector<bool> result(std::size_t(width) * height, false);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::size_t pixel = std::size_t(y) * width + x;
            for (int v = std::max(y - 1, 0); v < std::min(y + 2, height) && !result[pixel]; ++v) {
                for (int u = std::max(x - 1, 0); u < std::min(x + 2, width); ++u)
                    if (unlike(pixel, std::size_t(v) * width + u)) result[pixel] = true;
            }
        }
    }
    return result;
}

const image::Layer* find_layer(const image::Image& picture, std::string_view name) {
    const auto found = std::ranges::find(picture.layers, name, &image::Layer::name);
    return found == picture.layers.end() ? nullptr : &*found;
}

void add(std::vector<bool>& edges, const std::vector<bool>& more) {
    for (std::size_t i = 0; i < edges.size(); ++i) edges[i] = edges[i] || more[i];
}

}  // namespace

std::vector<bool> edges_by_contrast(const image::Image& picture, double contrast) {
    return edges(picture.width, picture.height, [&](std::size_t a, std::size_t b) {
        for (std::size_t c = 0; c < 3; ++c)
            if (std::abs(picture.rgb[3 * a + c] - picture.rgb[3 * b + c]) > contrast) return true;
        return false;
    });
}

std::vector<bool> edges_by_layer(const image::Image& picture, const image::Layer& ids) {
    return edges(picture.width, picture.height,
                 [&](std::size_t a, std::size_t b) { return ids.values[a] != ids.values[b]; });
}

Regions regions_by_contrast(const image::Image& picture) {
    const auto is_edge = edges_by_contrast(picture);
    auto is_elsewhere = is_edge;
    is_elsewhere.flip();
    return {{{"edges", is_edge}, {"elsewhere", is_elsewhere}},
            fmt::format("edges: pixels of the first picture that differ from a neighbour by more "
                        "than {}",
                        edge_contrast)};
}

std::optional<Regions> regions_by_layers(const image::Image& picture) {
    const auto* media = find_layer(picture, "medium.ID");
    const auto* objects = find_layer(picture, "object.ID");
    if (!media || !objects) return std::nullopt;
    auto is_edge = edges_by_contrast(picture);
    add(is_edge, edges_by_layer(picture, *media));
    add(is_edge, edges_by_layer(picture, *objects));
    std::vector<bool> is_inside(is_edge.size());
    for (std::size_t i = 0; i < is_edge.size(); ++i) is_inside[i] = media->values[i] >= 0.0f;
    return regions_of(
        is_inside, is_edge,
        fmt::format(
            "by the layers medium.ID and object.ID: inside glass where a medium lies behind "
            "the first surface; edges where neighbours show another medium or object, or "
            "differ by more than {}",
            edge_contrast));
}

Regions regions_of(const std::vector<bool>& inside, const std::vector<bool>& edges,
                   std::string how) {
    Regions result{{{"inside glass", std::vector<bool>(edges.size())},
                    {"outside", std::vector<bool>(edges.size())},
                    {"edges", edges}},
                   std::move(how)};
    for (std::size_t i = 0; i < edges.size(); ++i)
        if (!edges[i]) result.parts[inside[i] ? 0 : 1].pixels[i] = true;
    return result;
}

}  // namespace meniscus::compare
