#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "compare/metrics.hpp"
#include "compare/regions.hpp"

namespace meniscus::compare {

/// One picture of a comparison.
struct Side {
    std::string name;  // "a.png", "POV-Ray"
    image::Image picture;
    std::vector<std::pair<std::string, std::string>> facts;  // "CPU seconds": "0.41"
    std::string command;                                     // makes the picture; empty: not known
};

struct Settings {
    double threshold = 0.01;  // a pixel that is off by more counts as off
    bool clip = false;        // compare values clipped to [0, 1]
    std::size_t worst = 8;    // so many of the worst pixels are told
};

struct WorstPixel {
    int x = 0, y = 0;  // in the full picture, from the top left
    double error = 0.0;
};

/// A picture beside a reference. Both are cut to the window that they share.
struct Comparison {
    Side reference, picture;
    Settings settings;
    Metrics all;
    Regions regions;
    std::vector<Metrics> by_region;  // in the order of regions.parts
    std::vector<WorstPixel> worst;
    std::vector<double> errors;  // each pixel's, rows from the top

    int x0() const { return reference.picture.x0; }
    int y0() const { return reference.picture.y0; }
    int width() const { return reference.picture.width; }
    int height() const { return reference.picture.height; }
};

/// The pictures cannot be laid upon each other.
struct Mismatch : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Throws `Mismatch` for pictures of different size or without a pixel in common. `regions`, if
/// given, are of the reference's window; otherwise they are found in the pictures' layers, or by
/// contrast.
Comparison compare(Side reference, Side picture, const Settings& settings,
                   std::optional<Regions> regions = std::nullopt);

/// The numbers, for people.
std::string format_text(const Comparison& comparison);

}  // namespace meniscus::compare
