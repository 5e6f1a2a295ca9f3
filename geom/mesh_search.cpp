#include "geom/mesh_search.hpp"

#include <bit>

// Highway compiles the part in the middle once for each kind of processor and takes the best at run
// time.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geom/mesh_search.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "geom/mesh_tests-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::geom {
namespace HWY_NAMESPACE {

template <class Real>
HWY_INLINE double walk(const MeshView& mesh, const TriangleBlock<Real>* blocks, const Ray& ray,
                       const Search& search, Crossings& out) {
    const BvhLine line(mesh.frame, ray);
    const TriangleLine exact(ray);
    double t_max = search.to;
    const float from = line.lower(search.from);
    float to = line.upper(t_max);
    BvhStack stack;
    int size = 0;
    stack[size++] = {0, from};
    while (size > 0) {
        BvhEntry entry = stack[--size];
        if (entry.near > to) continue;
        while (!(entry.child & BvhNode::leaf)) {
            const BvhNode& node = mesh.nodes[entry.child];
            alignas(32) float near[BvhNode::width];
            unsigned met = children_met(line, node, from, to, near);
            if (met == 0) break;
            // Into the nearest child; the others wait, the nearer ones on top.
            int nearest = std::countr_zero(met);
            met &= met - 1;
            const int bottom = size;
            for (; met != 0; met &= met - 1) {
                int child = std::countr_zero(met);
                if (near[child] < near[nearest]) std::swap(child, nearest);
                int place = size++;
                for (; place > bottom && stack[place - 1].near < near[child]; --place)
                    stack[place] = stack[place - 1];
                stack[place] = {node.child[child], near[child]};
                fetch_child<3>(mesh, blocks, node.child[child]);
            }
            entry = {node.child[nearest], near[nearest]};
        }
        if (!(entry.child & BvhNode::leaf)) continue;

        const std::uint32_t number = entry.child ^ BvhNode::leaf;
        if (take_hits(exact, blocks[number], number, search, t_max, out)) to = line.upper(t_max);
    }
    return t_max;
}

double walk_singles(const MeshView& mesh, const TriangleBlock<float>* blocks, const Ray& ray,
                    const Search& search, Crossings& out) {
    return walk(mesh, blocks, ray, search, out);
}
double walk_doubles(const MeshView& mesh, const TriangleBlock<double>* blocks, const Ray& ray,
                    const Search& search, Crossings& out) {
    return walk(mesh, blocks, ray, search, out);
}

}  // namespace HWY_NAMESPACE
}  // namespace meniscus::geom
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace meniscus::geom {

HWY_EXPORT(walk_singles);
HWY_EXPORT(walk_doubles);

double find_crossings(const MeshView& mesh, const Ray& ray, const Search& search, Crossings& out) {
    return mesh.blocks.visit([&](const auto& blocks) {
        if constexpr (std::is_same_v<decltype(blocks), const TriangleBlocks::Singles&>) {
            return HWY_DYNAMIC_DISPATCH(walk_singles)(mesh, blocks.data(), ray, search, out);
        } else {
            return HWY_DYNAMIC_DISPATCH(walk_doubles)(mesh, blocks.data(), ray, search, out);
        }
    });
}

}  // namespace meniscus::geom
#endif
