#include "povray/write_lathe.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "povray/cut_profile.hpp"
#include "povray/writer.hpp"

namespace meniscus::povray {
namespace {

using geom::Vec2;

/// No curve is longer than this part of the profile, but for the most cuts.
constexpr double longest_part = 1.0 / 96.0;
constexpr double most_cuts = 64.0;

/// A line among curves. Written by its thirds it is a cubic whose higher terms are rounding, which
/// at some scales POV-Ray takes for true ones and then finds no roots; uneven steps make them
/// large.
std::array<Vec2, 4> straight_curve(const geom::ProfilePiece& piece) {
    const Vec2 way = piece.end - piece.start;
    return {piece.start, piece.start + 0.4 * way, piece.start + 0.7 * way, piece.end};
}

std::vector<Vec2> bezier_points(const geom::Profile& profile) {
    std::vector<Vec2> points;
    for (const auto& piece : profile.pieces()) {
        if (piece.straight) {
            const auto line = straight_curve(piece);
            points.insert(points.end(), line.begin(), line.end());
            continue;
        }
        const double part = glm::length(piece.end - piece.start) / profile.size();
        const int curves = int(std::clamp(std::ceil(part / longest_part), 1.0, most_cuts));
        const auto more = cut(piece, curves);
        points.insert(points.end(), more.begin(), more.end());
    }
    return points;
}

std::string joined(const std::vector<Vec2>& points) {
    std::string text;
    for (std::size_t i = 0; i < points.size(); ++i) {
        text += place(points[i]);
        if (i + 1 < points.size()) text += (i + 1) % 4 == 0 ? ",\n        " : ", ";
    }
    return text;
}

}  // namespace

std::string lathe_head(const geom::Lathe& lathe) {
    const bool is_linear = lathe.spline() == geom::Spline::linear;
    const auto points =
        is_linear ? lathe.points() : bezier_points(geom::Profile(lathe.spline(), lathe.points()));
    return fmt::format("{} {},\n        {}", is_linear ? "linear_spline" : "bezier_spline",
                       points.size(), joined(points));
}

}  // namespace meniscus::povray
