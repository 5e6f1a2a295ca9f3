#include "geom/bvh.hpp"

#include <tbb/parallel_for.h>

#include <cmath>

namespace meniscus::geom {

BvhLine::BvhLine(const Bounds& bounds, const Vec3& center, const Ray& ray) {
    const double dd = glm::dot(ray.direction, ray.direction), size = std::sqrt(dd);
    const Vec3 from_center = ray.from(center);
    shift = -glm::dot(from_center, ray.direction) / dd;
    const Vec3 origin = from_center + shift * ray.direction;

    // Errors of crossings are a few double roundoffs of the largest coordinate in play; those in
    // here, of the offset from the centre.
    const Vec3 reach = 0.5 * bounds.size();
    const double far = max_abs(ray.origin) + glm::max(max_abs(bounds.low), max_abs(bounds.high));
    const double margin =
        128.0 * unit_roundoff * far + 0x1p-20 * (max_abs(reach) + max_abs(origin));
    slack = static_cast<float>(margin / size);
    for (int axis = 0; axis < 3; ++axis) {
        const double d = ray.direction[axis];
        backwards[axis] = d < 0.0;
        // A direction of 0 would give 0 * infinity; a tiny one is as good and gives large numbers
        // of the right sign.
        inverse[axis] = static_cast<float>(glm::abs(d) < 1e-18 * size ? 1e18 / size : 1.0 / d);
        const double outwards = d < 0.0 ? -margin : margin;
        near_side[axis] = static_cast<float>(origin[axis] + outwards);
        far_side[axis] = static_cast<float>(origin[axis] - outwards);
    }
}

Bvh::Bvh(std::span<const Bounds> boxes, std::uint32_t leaf_size) : leaf_size_(leaf_size) {
    for (const Bounds& box : boxes) bounds_.extend(box);
    if (boxes.empty()) return;
    center_ = bounds_.center();
    std::vector<BuildItem> items(boxes.size());
    tbb::parallel_for(std::size_t{0}, boxes.size(), [&](std::size_t i) {
        items[i] = BuildItem(boxes[i], center_, static_cast<std::uint32_t>(i));
    });
    nodes_ = build_bvh(items, leaf_size);
    order_.reserve(items.size());
    for (const BuildItem& item : items) order_.push_back(item.index());
}

}  // namespace meniscus::geom
