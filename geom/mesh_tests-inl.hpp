// How boxes and triangles are tested several at once, in as many lanes as the processor has.

#if defined(MENISCUS_GEOM_MESH_TESTS) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_GEOM_MESH_TESTS
#undef MENISCUS_GEOM_MESH_TESTS
#else
#define MENISCUS_GEOM_MESH_TESTS
#endif

#include <hwy/highway.h>

#include <bit>

#include "geom/bvh_line.hpp"
#include "geom/mesh_search.hpp"
#include "geom/watertight.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::geom::HWY_NAMESPACE {

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
    const double* const origin = glm::value_ptr(ray.origin);
    const double* const error = glm::value_ptr(ray.origin_error);
    const V ox = hn::Set(d, origin[ax]), qx = hn::Set(d, error[ax]);
    const V oy = hn::Set(d, origin[ay]), qy = hn::Set(d, error[ay]);
    const V oz = hn::Set(d, origin[az]), qz = hn::Set(d, error[az]);
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

/// Appends the crossings that a search wants with the triangles of a block; whether one of them
/// draws `t_max` in.
template <class Real>
HWY_INLINE bool take_hits(const TriangleLine& line, const TriangleBlock<Real>& block,
                          std::uint32_t number, const Search& search, double& t_max,
                          Crossings& out) {
    bool is_drawn_in = false;
    for (unsigned left = candidates(line, block); left != 0; left &= left - 1) {
        const int lane = std::countr_zero(left);
        const auto corner = [&](int i) HWY_ATTR {
            return Vec3{block.at[i][0][lane], block.at[i][1][lane], block.at[i][2][lane]};
        };
        const auto hit = line.hit(corner(0), corner(1), corner(2));
        if (!hit) continue;
        const auto face = static_cast<Face>(number * TriangleBlock<Real>::width + lane);
        if (face == search.own && search.own_met) {
            *search.own_met = {hit->t, face, hit->entering};
            continue;
        }
        if (!(hit->t > search.from) || hit->t > t_max) continue;
        out.push_back({hit->t, face, hit->entering});
        if ((hit->entering ? search.entering_ends : search.leaving_ends) && face != search.own &&
            hit->t >= search.ends_from) {
            const double end = hit->t + (search.slack + search.slack_per_t * hit->t);
            if (end < t_max) {
                t_max = end;
                is_drawn_in = true;
            }
        }
    }
    return is_drawn_in;
}

/// Asks for the first lines of what waits, so that they are here when its turn comes. All four
/// would crowd out more than they bring where one ray walks alone: a mesh of 70,000 triangles is 6
/// % slower with them.
template <int lines, class Real>
HWY_INLINE void fetch_child(const MeshView& mesh, const TriangleBlock<Real>* blocks,
                            std::uint32_t child) {
    // Looked up, since nobody can guess which of the two it is.
    const char* const begins[] = {reinterpret_cast<const char*>(mesh.nodes),
                                  reinterpret_cast<const char*>(blocks)};
    constexpr std::size_t sizes[] = {sizeof(BvhNode), sizeof(TriangleBlock<Real>)};
    const std::size_t is_leaf = child / BvhNode::leaf;
    const char* const begin = begins[is_leaf] + sizes[is_leaf] * (child % BvhNode::leaf);
    for (int line = 0; line < lines; ++line) __builtin_prefetch(begin + 64 * line);
}

}  // namespace meniscus::geom::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
