#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "tracer/render_scene.hpp"

namespace meniscus::tracer {

/// What a ray is inside of: for each part, how many times, and when it was last entered (Schmidt
/// and Budge 2002, with counts). It has no fixed size: a few members stand in the list itself, and
/// many in memory that its copies share until one of them changes. A depth may be negative inside
/// the complement of a mesh that overlaps itself.
class InteriorList {
public:
    struct Member {
        int part;
        int depth;
        std::uint64_t serial;  // of the latest entry
    };

    bool empty() const { return size() == 0; }
    std::size_t size() const { return many_ ? many_->size() : count_; }
    const Member* begin() const { return many_ ? many_->data() : few_.data(); }
    const Member* end() const { return begin() + size(); }

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
    static constexpr std::size_t most_few = 6;
    static constexpr int unknown = -2;

    Member* find(int part);
    void add(const Member& member);
    void remove(Member* member);
    int find_top(const RenderScene& scene) const;

    std::array<Member, most_few> few_;
    std::uint32_t count_ = 0;  // of those
    // What was on top when it was last asked, and what was entered since then.
    mutable int top_ = outside, entered_ = outside;
    std::uint64_t next_serial_ = 1;
    std::shared_ptr<std::vector<Member>> many_;  // in place of `few_`, if set
};

/// The medium that a solid is made of; the scene's outside for `outside`.
inline const scene::Interior& medium(const RenderScene& scene, int solid) {
    return solid == outside ? scene.source.settings.outside : scene.source.solids[solid].interior;
}

}  // namespace meniscus::tracer
