#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <variant>

#include "geom/crossing.hpp"
#include "geom/huge_pages.hpp"
#include "geom/vec.hpp"

namespace meniscus::geom {

using TriangleIndices = std::array<std::uint32_t, 3>;

/// Four triangles that are tested together.
template <class Real>
struct alignas(4 * sizeof(Real)) TriangleBlock {
    static constexpr std::uint32_t width = 4;

    std::array<std::array<std::array<Real, width>, 3>, 3> at;  // [corner][axis][triangle]
};

/// The triangles of a mesh with their corners' coordinates, four by four: in single precision where
/// each of them is exactly a float, which loses nothing, else in double.
class TriangleBlocks {
public:
    using Singles = HugeVector<TriangleBlock<float>>;
    using Doubles = HugeVector<TriangleBlock<double>>;

    TriangleBlocks() = default;
    TriangleBlocks(std::span<const Vec3> positions, std::span<const TriangleIndices> triangles);

    std::size_t size() const { return size_; }
    std::size_t memory_bytes() const;
    /// Turns a triangle round: swaps its second and third corner.
    void flip(Face face);

    /// Calls use(vector of blocks), of either precision.
    template <class Use>
    decltype(auto) visit(Use&& use) const {
        if (const auto* singles = std::get_if<Singles>(&blocks_)) return use(*singles);
        return use(*std::get_if<Doubles>(&blocks_));
    }

    std::array<Vec3, 3> corners(Face face) const {
        const auto triangle = static_cast<std::uint32_t>(face);
        return visit([&](const auto& blocks) {
            const auto& at = blocks[triangle / 4].at;
            const std::uint32_t lane = triangle % 4;
            std::array<Vec3, 3> corners;
            for (std::size_t corner = 0; corner < 3; ++corner)
                corners[corner] = {at[corner][0][lane], at[corner][1][lane], at[corner][2][lane]};
            return corners;
        });
    }

private:
    std::variant<Singles, Doubles> blocks_;
    std::size_t size_ = 0;  // triangles; those that fill up the last block are points
};

}  // namespace meniscus::geom
