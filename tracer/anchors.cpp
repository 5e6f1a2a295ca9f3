#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "tracer/render_scene.hpp"

namespace meniscus::tracer {
namespace {

/// Nearer to the origin than this many sizes, no film is thinner than the plain tolerance and
/// thicker than the finer one by more than a few digits.
constexpr double near_origin = 64.0;

/// Equal for two parts exactly if they share an anchor: kind, point and direction, or the
/// transform.
using Key = std::array<double, 16>;

struct Candidate {
    Key key;
    int part;
    geom::Anchor anchor;
    std::optional<double> radius;  // of faces that stay at one distance from others about the same
                                   // centre or axis
};

Key key_of(const geom::Anchor& anchor) {
    Key key{double(anchor.kind)};
    if (anchor.kind == geom::Anchor::Kind::frame) {
        for (int i = 0; i < 9; ++i) key[std::size_t(i + 1)] = anchor.frame.linear()[i / 3][i % 3];
    }
    for (int i = 0; i < 3; ++i) {
        const double d = anchor.direction[i];
        // Two cylinders along a coordinate axis may stand at different places of one axis.
        key[std::size_t(10 + i)] = std::abs(d) == 1.0 ? 0.0 : anchor.point[i];
        key[std::size_t(13 + i)] = std::abs(d) == 1.0 ? 1.0 : d;
    }
    return key;
}

std::optional<double> radius_of(const geom::Shape& shape) {
    if (const auto* sphere = std::get_if<geom::Sphere>(&shape)) return sphere->radius;
    if (const auto* cylinder = std::get_if<geom::Cylinder>(&shape)) return cylinder->radius;
    return std::nullopt;
}

/// Whether some of the parts, which share an anchor, may have a film between them that the plain
/// tolerance closes. Of round ones about one centre or axis that is seen; others, which may have a
/// film of their own, are only asked how far away they are.
bool ask_for_anchor(const std::vector<Candidate>& all, std::size_t begin, std::size_t end,
                    double scene_reach) {
    std::vector<double> radii;
    double size = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
        const geom::Anchor& anchor = all[i].anchor;
        size = std::max(size, anchor.size);
        if (all[i].radius && anchor.kind != geom::Anchor::Kind::frame) {
            radii.push_back(*all[i].radius);
        } else if (geom::max_abs(anchor.point) > geom::far_from_origin * anchor.size &&
                   (anchor.kind == geom::Anchor::Kind::frame || end - begin > 1)) {
            return true;
        }
    }
    std::ranges::sort(radii);
    const double plain = 64.0 * 16.0 * geom::unit_roundoff * scene_reach;
    for (std::size_t i = 1; i < radii.size(); ++i) {
        const double film = radii[i] - radii[i - 1];
        if (film > 4.0 * geom::unit_roundoff * size && film < plain) return true;
    }
    return false;
}

}  // namespace

void find_anchors(RenderScene& scene) {
    std::vector<Candidate> candidates;
    double farthest = geom::max_abs(scene.source.camera.location);
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        const geom::PlacedShape& shape = scene.parts[i].shape;
        const geom::Bounds& bounds = shape.bounds();
        if (bounds.is_finite())
            farthest = std::max({farthest, geom::max_abs(bounds.low), geom::max_abs(bounds.high)});
        if (!shape.is_closed()) continue;
        const std::optional<geom::Anchor> anchor = shape.anchor();
        if (!anchor || geom::max_abs(anchor->point) < near_origin * anchor->size) continue;
        candidates.push_back({key_of(*anchor), int(i), *anchor, radius_of(shape.shape())});
    }
    std::ranges::sort(candidates, [](const Candidate& a, const Candidate& b) {
        return a.key != b.key ? a.key < b.key : a.part < b.part;
    });
    for (std::size_t begin = 0, end = 0; begin < candidates.size(); begin = end) {
        while (end < candidates.size() && candidates[end].key == candidates[begin].key) ++end;
        if (!ask_for_anchor(candidates, begin, end, 2.0 * farthest + scene.size)) continue;
        const geom::Anchor& first = candidates[begin].anchor;
        SharedAnchor shared{first.point, 0.0, first.face};
        for (std::size_t i = begin; i < end; ++i) {
            const geom::Anchor& anchor = candidates[i].anchor;
            shared.size =
                std::max(shared.size, glm::length(anchor.point - first.point) + anchor.size);
            scene.parts[std::size_t(candidates[i].part)].anchor = int(scene.anchors.size());
        }
        scene.anchors.push_back(shared);
    }
}

}  // namespace meniscus::tracer
