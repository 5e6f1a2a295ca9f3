#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "tracer/levels.hpp"
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

/// Whether some of the parts, which share an anchor, may have a film between them that the plain
/// tolerance closes. That is seen by the distances of what is parallel; of parts that lie far away
/// it is not asked.
bool ask_for_anchor(const RenderScene& scene, std::span<const Candidate> sharing,
                    double scene_reach) {
    const geom::Anchor& first = sharing.front().anchor;
    const bool is_frame = first.kind == geom::Anchor::Kind::frame;
    if (sharing.size() == 1 && !is_frame) return false;
    double size = 0.0;
    std::vector<Level> levels;
    for (const Candidate& candidate : sharing) {
        const geom::Anchor& anchor = candidate.anchor;
        size = std::max(size, anchor.size);
        const geom::Shape& shape = scene.parts[std::size_t(candidate.part)].shape.shape();
        const bool is_asked = anchor.kind == geom::Anchor::Kind::center ||
                              std::holds_alternative<geom::Cylinder>(shape);
        if (geom::max_abs(anchor.point) > geom::far_from_origin * anchor.size &&
            (is_frame || (!is_asked && sharing.size() > 1)))
            return true;
        add_levels(shape, is_frame ? geom::Vec3{0.0} : first.point, levels);
    }
    // Of cylinders and cones only the sides share the axis.
    if (first.face != geom::no_face)
        std::erase_if(levels, [](const Level& level) { return level.kind == Level::Kind::planes; });
    const double scale = is_frame ? first.frame.largest_scale() : 1.0;
    const double rounding = 4.0 * geom::unit_roundoff * size;
    const double plain = 64.0 * 16.0 * geom::unit_roundoff * scene_reach;
    return has_film(levels, size / scale, rounding / scale, plain / scale);
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
        candidates.push_back({key_of(*anchor), int(i), *anchor});
    }
    std::ranges::sort(candidates, [](const Candidate& a, const Candidate& b) {
        return a.key != b.key ? a.key < b.key : a.part < b.part;
    });
    for (std::size_t begin = 0, end = 0; begin < candidates.size(); begin = end) {
        while (end < candidates.size() && candidates[end].key == candidates[begin].key) ++end;
        const std::span sharing(candidates.data() + begin, end - begin);
        if (!ask_for_anchor(scene, sharing, 2.0 * farthest + scene.size)) continue;
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
