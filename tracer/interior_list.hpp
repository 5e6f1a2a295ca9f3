#pragma once

#include <cstdint>

#include "geom/inline_vector.hpp"
#include "tracer/render_scene.hpp"

namespace meniscus::tracer {

/// What a ray is inside of: for each part, how many times, and when it was last entered (Schmidt
/// and Budge 2002, with counts). It has no fixed size. A depth may be negative inside the
/// complement of a mesh that overlaps itself.
class InteriorList {
public:
    struct Member {
        int part;
        int depth;
        std::uint64_t serial;  // of the latest entry
    };

    bool empty() const { return members_.empty(); }
    const Member* begin() const { return members_.begin(); }
    const Member* end() const { return members_.end(); }

    int depth(int part) const;
    bool inside(int part) const { return depth(part) > 0; }
    void enter(int part);
    void leave(int part);
    /// The part that is there: of highest priority, on a tie the one entered last; `outside` when
    /// there is none.
    int top(const RenderScene& scene) const;
    /// The solid of `top`, or `outside`.
    int top_solid(const RenderScene& scene) const;

private:
    void change(int part, int by, bool entering);

    geom::InlineVector<Member, 6> members_;
    std::uint64_t next_serial_ = 1;
};

/// The medium that a solid is made of; the scene's outside for `outside`.
inline const scene::Interior& medium(const RenderScene& scene, int solid) {
    return solid == outside ? scene.source.settings.outside : scene.source.solids[solid].interior;
}

}  // namespace meniscus::tracer
