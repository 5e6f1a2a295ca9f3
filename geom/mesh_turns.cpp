// Rays through a mesh that take turns. Hardly a branch here depends on a ray, for such a one is
// often guessed wrongly; so what the processor does for one ray it can begin while the others'
// numbers are still on their way.

#include <array>
#include <cstddef>
#include <limits>
#include <new>
#include <utility>

#include "geom/mesh_search.hpp"

#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geom/mesh_turns.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "geom/mesh_tests-inl.hpp"

#ifndef MENISCUS_GEOM_MESH_TURNS_ONCE
#define MENISCUS_GEOM_MESH_TURNS_ONCE
namespace meniscus::geom {

/// A ray on its way. What waits for it stands in two arrays, the last on top; below all of it lies
/// the end of the search.
struct WalkingRay {
    static constexpr std::uint32_t at_end = 0xffffffff;

    WalkingRay(const BvhFrame& frame, SearchedRay& which)
        : line(frame, which.ray),
          from(line.lower(which.search.from)),
          to(line.upper(which.search.to)),
          searched(&which),
          exact(which.ray) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            first[axis] = line.backwards[axis] ? BvhNode::width : 0;
            last[axis] = BvhNode::width - first[axis];
            enter_shift[axis] = line.near_side[axis] * line.inverse[axis];
            leave_shift[axis] = line.far_side[axis] * line.inverse[axis];
        }
        searched->end = searched->search.to;
        waiting[0] = at_end;
        near[0] = -std::numeric_limits<float>::infinity();
    }

    /// Goes on with what is on top of the stack, and is not too far away.
    void pop() {
        do {
            --size;
        } while (near[size] > to);
        child = waiting[size];
    }

    BvhLine line;
    float from, to;
    std::uint32_t child = 0;  // where the ray is
    int size = 1;             // of the stack
    // Of an axis' sides the first and the last that the line comes to, counted in numbers from the
    // node's first; and where it does, at side * inverse - shift.
    std::array<std::uint32_t, 3> first, last;
    std::array<float, 3> enter_shift, leave_shift;
    SearchedRay* searched;
    TriangleLine exact;
    static constexpr std::size_t most = std::tuple_size_v<BvhStack> + BvhNode::width;
    std::array<std::uint32_t, most> waiting;
    std::array<float, most> near;
};

/// For each set of children the places of its members, to bring them together.
struct PackingTable {
    std::array<std::array<std::uint8_t, 8>, 256> places{};
    constexpr PackingTable() {
        for (unsigned set = 0; set < 256; ++set) {
            std::size_t count = 0;
            for (unsigned i = 0; i < 8; ++i) {
                if ((set >> i & 1) != 0) places[set][count++] = static_cast<std::uint8_t>(i);
            }
        }
    }
};
inline constexpr PackingTable packing_table;

}  // namespace meniscus::geom
#endif

HWY_BEFORE_NAMESPACE();
namespace meniscus::geom {
namespace HWY_NAMESPACE {

/// As `children_met`, with the numbers that a walking ray has at hand. The shifts' roundings take
/// the place of the differences' (docs/numerics.md).
HWY_INLINE unsigned children_met(const WalkingRay& ray, const BvhNode& node,
                                 float* HWY_RESTRICT near) {
    const hn::CappedTag<float, BvhNode::width> d;
    unsigned met = 0;
    for (std::size_t i = 0; i < BvhNode::width; i += hn::Lanes(d)) {
        auto enter = hn::Set(d, ray.from), leave = hn::Set(d, ray.to);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const float* const sides = node.sides[axis][0].data() + i;
            const auto inverse = hn::Set(d, ray.line.inverse[axis]);
            enter = hn::Max(hn::MulSub(hn::Load(d, sides + ray.first[axis]), inverse,
                                       hn::Set(d, ray.enter_shift[axis])),
                            enter);
            leave = hn::Min(hn::MulSub(hn::Load(d, sides + ray.last[axis]), inverse,
                                       hn::Set(d, ray.leave_shift[axis])),
                            leave);
        }
        hn::Store(enter, d, near + i);
        met |= bits_of(d, hn::Le(enter, leave)) << i;
    }
    return met;
}

/// The nearest child of a set; of an empty one, any.
HWY_INLINE int nearest_of(unsigned set, const float* HWY_RESTRICT near) {
    const hn::CappedTag<float, BvhNode::width> d;
    if constexpr (hn::MaxLanes(d) == BvhNode::width) {
        // Each distance carries its place in its last three bits.
        const hn::RebindToSigned<decltype(d)> di;
        const auto place = hn::Iota(di, 0);
        const auto is_in =
            hn::TestBit(hn::Set(di, static_cast<int>(set)), hn::Shl(hn::Set(di, 1), place));
        const auto largest = hn::Set(d, std::numeric_limits<float>::max());
        const auto distance =
            hn::IfThenElse(hn::RebindMask(d, is_in), hn::Min(hn::Load(d, near), largest), largest);
        const auto key = hn::Or(hn::And(hn::BitCast(di, distance), hn::Set(di, ~7)), place);
        return hn::GetLane(hn::BitCast(di, hn::MinOfLanes(d, hn::BitCast(d, key)))) & 7;
    } else {
        int nearest = set != 0 ? std::countr_zero(set) : 0;
        for (unsigned left = set; left != 0; left &= left - 1) {
            const int i = std::countr_zero(left);
            if (near[i] < near[nearest]) nearest = i;
        }
        return nearest;
    }
}

/// Puts the children of a set on the ray's stack, above what is in use of it, in no order: to sort
/// them would cost more wrong guesses than it saves nodes.
HWY_INLINE void put_aside(WalkingRay& ray, const BvhNode& node, unsigned set,
                          const float* HWY_RESTRICT near) {
    std::uint32_t* const waiting = ray.waiting.data() + ray.size;
    float* const its_near = ray.near.data() + ray.size;
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
    __m256i child = _mm256_load_si256(reinterpret_cast<const __m256i*>(node.child.data()));
    __m256 distance = _mm256_load_ps(near);
#if HWY_TARGET == HWY_AVX3
    child = _mm256_maskz_compress_epi32(static_cast<__mmask8>(set), child);
    distance = _mm256_maskz_compress_ps(static_cast<__mmask8>(set), distance);
#else
    const __m256i places = _mm256_cvtepu8_epi32(
        _mm_loadl_epi64(reinterpret_cast<const __m128i*>(packing_table.places[set].data())));
    child = _mm256_permutevar8x32_epi32(child, places);
    distance = _mm256_permutevar8x32_ps(distance, places);
#endif
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(waiting), child);
    _mm256_storeu_ps(its_near, distance);
#else
    for (int top = 0; set != 0; set &= set - 1, ++top) {
        const int i = std::countr_zero(set);
        waiting[top] = node.child[static_cast<std::size_t>(i)];
        its_near[top] = near[i];
    }
#endif
}

/// Into the nearest child of a node, or on to what waits.
HWY_INLINE void pass_node(WalkingRay& ray, const BvhNode& node) {
    alignas(32) float near[BvhNode::width];
    const unsigned met = children_met(ray, node, near);
    const int nearest = nearest_of(met, near);
    put_aside(ray, node, met & ~(1u << nearest), near);
    ray.size += std::popcount(met) - 1;
    const std::uint32_t inner = node.child[static_cast<std::size_t>(nearest)];
    const std::uint32_t next = ray.waiting[static_cast<std::size_t>(ray.size)];
    const float its_near = ray.near[static_cast<std::size_t>(ray.size)];
    const std::uint32_t goes_in = 0u - static_cast<std::uint32_t>(met != 0);  // all bits or none
    ray.child = (inner & goes_in) | (next & ~goes_in);
    const unsigned is_too_far = static_cast<unsigned>(its_near > ray.to) & ~goes_in;
    if (is_too_far != 0) ray.pop();
}

template <class Real>
HWY_INLINE void walk_all(const MeshView& mesh, const TriangleBlock<Real>* blocks,
                         std::span<SearchedRay> rays) {
    constexpr std::size_t most = 16;
    alignas(64) std::byte memory[most][sizeof(WalkingRay)];
    for (; rays.size() > 0; rays = rays.subspan(std::min(most, rays.size()))) {
        std::array<WalkingRay*, most> at_node, at_leaf;
        std::size_t nodes = 0, leaves = 0;
        for (; nodes < std::min(most, rays.size()); ++nodes)
            at_node[nodes] = new (memory[nodes]) WalkingRay(mesh.frame, rays[nodes]);
        while (nodes + leaves > 0) {
            std::size_t still = 0, arrived = leaves;
            const auto sort_in = [&](WalkingRay* ray) HWY_ATTR {
                const std::uint32_t child = ray->child;
                const std::size_t is_leaf = child / BvhNode::leaf;
                at_node[still] = at_leaf[arrived] = ray;
                still += 1 - is_leaf;
                arrived += is_leaf & static_cast<std::size_t>(child != WalkingRay::at_end);
                fetch_child<4>(mesh, blocks, child);
            };
            for (std::size_t i = 0; i < nodes; ++i) {
                WalkingRay* const ray = at_node[i];
                pass_node(*ray, mesh.nodes[ray->child]);
                sort_in(ray);
            }
            leaves = std::exchange(arrived, 0);
            for (std::size_t i = 0; i < leaves; ++i) {
                WalkingRay* const ray = at_leaf[i];
                SearchedRay& searched = *ray->searched;
                const std::uint32_t block = ray->child ^ BvhNode::leaf;
                if (take_hits(ray->exact, blocks[block], block, searched.search, searched.end,
                              searched.found))
                    ray->to = ray->line.upper(searched.end);
                ray->pop();
                sort_in(ray);
            }
            nodes = still;
            leaves = arrived;
        }
    }
}

void walk_singles_in_turns(const MeshView& mesh, const TriangleBlock<float>* blocks,
                           std::span<SearchedRay> rays) {
    walk_all(mesh, blocks, rays);
}
void walk_doubles_in_turns(const MeshView& mesh, const TriangleBlock<double>* blocks,
                           std::span<SearchedRay> rays) {
    walk_all(mesh, blocks, rays);
}

}  // namespace HWY_NAMESPACE
}  // namespace meniscus::geom
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace meniscus::geom {

HWY_EXPORT(walk_singles_in_turns);
HWY_EXPORT(walk_doubles_in_turns);

void find_crossings(const MeshView& mesh, std::span<SearchedRay> rays) {
    mesh.blocks.visit([&](const auto& blocks) {
        if constexpr (std::is_same_v<decltype(blocks), const TriangleBlocks::Singles&>) {
            HWY_DYNAMIC_DISPATCH(walk_singles_in_turns)(mesh, blocks.data(), rays);
        } else {
            HWY_DYNAMIC_DISPATCH(walk_doubles_in_turns)(mesh, blocks.data(), rays);
        }
    });
}

}  // namespace meniscus::geom
#endif
