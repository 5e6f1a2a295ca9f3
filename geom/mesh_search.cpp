#include "geom/mesh_search.hpp"

#include <bit>

#include "geom/bvh_line.hpp"
#include "geom/watertight.hpp"

// Highway compiles the part in the middle once for each kind of processor and takes the best at run
// time.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geom/mesh_search.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace meniscus::geom {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class D, class M>
HWY_INLINE unsigned bits_of(D d, M mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    return bytes[0];
}

/// As `meets` of bvh.hpp, in wider lanes.
HWY_INLINE unsigned children_met(const BvhLine& line, const BvhNode& node, float from, float to,
                                 float* HWY_RESTRICT near) {
    const hn::CappedTag<float, BvhNode::width> d;
    unsigned met = 0;
    for (std::size_t i = 0; i < BvhNode::width; i += hn::Lanes(d)) {
        auto enter = hn::Set(d, from), leave = hn::Set(d, to);
        for (int axis = 0; axis < 3; ++axis) {
            const auto& sides = node.sides[axis];
            const auto first = hn::Load(d, sides[line.backwards[axis]].data() + i);
            const auto last = hn::Load(d, sides[!line.backwards[axis]].data() + i);
            const auto inverse = hn::Set(d, line.inverse[axis]);
            enter =
                hn::Max(hn::Mul(hn::Sub(first, hn::Set(d, line.near_side[axis])), inverse), enter);
            leave =
                hn::Min(hn::Mul(hn::Sub(last, hn::Set(d, line.far_side[axis])), inverse), leave);
        }
        hn::Store(enter, d, near + i);
        met |= bits_of(d, hn::Le(enter, leave)) << i;
    }
    return met;
}

/// Coordinates in double, of whichever precision they are stored in.
template <class D>
HWY_INLINE hn::Vec<D> load(D d, const double* HWY_RESTRICT from) {
    return hn::Load(d, from);
}
template <class D>
HWY_INLINE hn::Vec<D> load(D d, const float* HWY_RESTRICT from) {
    return hn::PromoteTo(d, hn::Load(hn::Rebind<float, D>(), from));
}

/// The triangles that no two edges tell to be missed: bit i for triangle i. All that are hit are
/// among them; where a product of the edge functions ties, some that are not.
template <class Real>
HWY_INLINE unsigned candidates(const TriangleLine& line, const TriangleBlock<Real>& block) {
    const hn::CappedTag<double, TriangleBlock<Real>::width> d;
    using V = hn::Vec<decltype(d)>;
    const Ray& ray = line.ray();
    const int ax = line.axes()[0], ay = line.axes()[1], az = line.axes()[2];
    const V ox = hn::Set(d, ray.origin[ax]), qx = hn::Set(d, ray.origin_error[ax]);
    const V oy = hn::Set(d, ray.origin[ay]), qy = hn::Set(d, ray.origin_error[ay]);
    const V oz = hn::Set(d, ray.origin[az]), qz = hn::Set(d, ray.origin_error[az]);
    const V sx = hn::Set(d, line.shear().x), sy = hn::Set(d, line.shear().y);
    unsigned found = 0;
    for (std::size_t i = 0; i < TriangleBlock<Real>::width; i += hn::Lanes(d)) {
        // From the corners to the origin: TriangleLine's vectors backwards, which changes no sign.
        const auto sheared = [&](int corner, V& x, V& y) HWY_ATTR {
            const auto& at = block.at[corner];
            const V ez = hn::Add(hn::Sub(oz, load(d, at[az].data() + i)), qz);
            const V ex = hn::Add(hn::Sub(ox, load(d, at[ax].data() + i)), qx);
            const V ey = hn::Add(hn::Sub(oy, load(d, at[ay].data() + i)), qy);
            x = hn::Sub(ex, hn::Mul(sx, ez));
            y = hn::Sub(ey, hn::Mul(sy, ez));
        };
        V px, py, qx_, qy_, rx, ry;
        sheared(0, px, py);
        sheared(1, qx_, qy_);
        sheared(2, rx, ry);
        const V a = hn::Mul(px, qy_), b = hn::Mul(py, qx_);
        const V e = hn::Mul(qx_, ry), f = hn::Mul(qy_, rx);
        const V g = hn::Mul(rx, py), h = hn::Mul(ry, px);
        const auto above = hn::Or(hn::Gt(a, b), hn::Or(hn::Gt(e, f), hn::Gt(g, h)));
        const auto below = hn::Or(hn::Lt(a, b), hn::Or(hn::Lt(e, f), hn::Lt(g, h)));
        found |= (bits_of(d, hn::And(above, below)) ^ ((1u << hn::Lanes(d)) - 1u)) << i;
    }
    return found;
}

/// Asks for the first lines of what waits, so that they are here when its turn comes. All of it
/// would crowd out more than it brings: a mesh of 70,000 triangles is 6 % slower with it.
template <class Real>
HWY_INLINE void fetch_child(const MeshView& mesh, const TriangleBlock<Real>* blocks,
                            std::uint32_t child) {
    const char* const begin = child & BvhNode::leaf
                                  ? reinterpret_cast<const char*>(blocks + (child ^ BvhNode::leaf))
                                  : reinterpret_cast<const char*>(mesh.nodes + child);
    for (int line = 0; line < 3; ++line) __builtin_prefetch(begin + 64 * line);
}

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
                fetch_child(mesh, blocks, node.child[child]);
            }
            entry = {node.child[nearest], near[nearest]};
        }
        if (!(entry.child & BvhNode::leaf)) continue;

        const std::uint32_t number = entry.child ^ BvhNode::leaf;
        const TriangleBlock<Real>& block = blocks[number];
        for (unsigned left = candidates(exact, block); left != 0; left &= left - 1) {
            const int lane = std::countr_zero(left);
            const auto corner = [&](int i) HWY_ATTR {
                return Vec3{block.at[i][0][lane], block.at[i][1][lane], block.at[i][2][lane]};
            };
            const auto hit = exact.hit(corner(0), corner(1), corner(2));
            if (!hit) continue;
            const auto face = static_cast<Face>(number * TriangleBlock<Real>::width + lane);
            if (face == search.own && search.own_met)
                *search.own_met = {hit->t, face, hit->entering};
            if (!(hit->t > search.from) || hit->t > t_max) continue;
            out.push_back({hit->t, face, hit->entering});
            if ((hit->entering ? search.entering_ends : search.leaving_ends) &&
                face != search.own && hit->t >= search.ends_from) {
                const double end = hit->t + (search.slack + search.slack_per_t * hit->t);
                if (end < t_max) {
                    t_max = end;
                    to = line.upper(t_max);
                }
            }
        }
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
