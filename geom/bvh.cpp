#include "geom/bvh.hpp"

#include <tbb/parallel_for.h>

#include <utility>

namespace meniscus::geom {

Bvh::Bvh(std::span<const Bounds> boxes, std::uint32_t leaf_size) : leaf_size_(leaf_size) {
    for (const Bounds& box : boxes) bounds_.extend(box);
    if (boxes.empty()) return;
    frame_ = BvhFrame(bounds_);
    std::vector<BuildItem> items(boxes.size());
    tbb::parallel_for(std::size_t{0}, boxes.size(), [&](std::size_t i) {
        items[i] = BuildItem(boxes[i], frame_.center, static_cast<std::uint32_t>(i));
    });
    nodes_ = build_bvh(items, leaf_size);
    order_.reserve(items.size());
    for (const BuildItem& item : items) order_.push_back(item.index());
    size_ = static_cast<std::uint32_t>(order_.size());
}

std::vector<std::uint32_t> Bvh::renumber() { return std::exchange(order_, {}); }

}  // namespace meniscus::geom
