#include "geom/triangle_blocks.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

namespace meniscus::geom {

namespace {

template <class Real>
HugeVector<TriangleBlock<Real>> packed(std::span<const Vec3> positions,
                                       std::span<const TriangleIndices> triangles) {
    constexpr std::size_t width = TriangleBlock<Real>::width;
    HugeVector<TriangleBlock<Real>> blocks((triangles.size() + width - 1) / width);
    tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t b) {
        for (std::size_t lane = 0; lane < width; ++lane) {
            const std::size_t triangle = b * width + lane;
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const Vec3& p = triangle < triangles.size() ? positions[triangles[triangle][corner]]
                                                            : positions[triangles.back()[0]];
                for (int axis = 0; axis < 3; ++axis)
                    blocks[b].at[corner][axis][lane] = static_cast<Real>(p[axis]);
            }
        }
    });
    return blocks;
}

bool is_single(const Vec3& p) {
    for (int axis = 0; axis < 3; ++axis) {
        if (static_cast<double>(static_cast<float>(p[axis])) != p[axis]) return false;
    }
    return true;
}

}  // namespace

TriangleBlocks::TriangleBlocks(std::span<const Vec3> positions,
                               std::span<const TriangleIndices> triangles)
    : size_(triangles.size()) {
    if (std::ranges::all_of(positions, is_single)) {
        blocks_ = packed<float>(positions, triangles);
    } else {
        blocks_ = packed<double>(positions, triangles);
    }
}

std::size_t TriangleBlocks::memory_bytes() const {
    return visit([](const auto& blocks) { return blocks.size() * sizeof(blocks[0]); });
}

void TriangleBlocks::flip(Face face) {
    const auto triangle = static_cast<std::uint32_t>(face);
    std::visit(
        [&](auto& blocks) {
            auto& at = blocks[triangle / 4].at;
            for (int axis = 0; axis < 3; ++axis)
                std::swap(at[1][axis][triangle % 4], at[2][axis][triangle % 4]);
        },
        blocks_);
}

}  // namespace meniscus::geom
