#pragma once

#include <optional>
#include <string>
#include <vector>

#include "image/image.hpp"

namespace meniscus::compare {

/// A part of a picture that has figures of its own.
struct Region {
    std::string name;
    std::vector<bool> pixels;
};

/// Parts that share no pixel and leave none out, and how they were told apart.
struct Regions {
    std::vector<Region> parts;
    std::string how;
};

/// Neighbours (of eight) that differ by more than this in a channel have an edge between them.
inline constexpr double edge_contrast = 0.1;

/// True for pixels that differ from one of their eight neighbours: a band two pixels wide along
/// each line between unlike pixels.
std::vector<bool> edges_by_contrast(const image::Image& picture, double contrast = edge_contrast);
std::vector<bool> edges_by_layer(const image::Image& picture, const image::Layer& ids);

/// "edges" and "elsewhere", by the picture alone.
Regions regions_by_contrast(const image::Image& picture);

/// "inside glass", "outside" and "edges", by the layers medium.ID and object.ID that `render
/// --layers all` adds, and by contrast; nothing if the picture has no such layers.
std::optional<Regions> regions_by_layers(const image::Image& picture);

/// "inside glass", "outside" and "edges"; an edge pixel belongs to neither side.
Regions regions_of(const std::vector<bool>& inside, const std::vector<bool>& edges,
                   std::string how);

}  // namespace meniscus::compare
