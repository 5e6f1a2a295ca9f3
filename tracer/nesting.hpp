#pragma once

#include <cstdint>
#include <vector>

#include "geom/bvh.hpp"

namespace meniscus::tracer {

struct RenderScene;

/// Which solids lie wholly inside of which. Where many stand in each other, all their bounds lie
/// around a ray; but what is around the solid that it is in cannot be met before that is left, nor
/// what is within another before that is entered.
struct Nesting {
    /// Parts that the same solid holds, or none.
    struct Group {
        std::vector<int> parts;
        geom::Bvh bvh;  // over them, by their places in `parts`; empty if they are few
    };
    struct Place {
        std::uint32_t level = 0;   // how many solids hold it
        std::uint32_t number = 0;  // those that it holds have the next ones...
        std::uint32_t last = 0;    // ...up to this one
        int held = -1;             // group of those right within it
        bool is_alone = false;     // nothing but what holds it comes near it
    };

    bool is_empty() const { return groups.empty(); }
    /// Whether `part` lies within `holder`, with more room than the margin.
    bool holds(int holder, int part) const {
        const Place &outer = places[std::size_t(holder)], &inner = places[std::size_t(part)];
        return outer.number < inner.number && inner.number <= outer.last;
    }

    std::vector<Group> groups;  // the first has what nothing holds
    std::vector<Place> places;  // by part
    double margin = 0.0;        // a surface is nearer to none that holds it
    std::uint32_t deepest = 0;
};

/// Empty unless the scene has solids so deep in each other that it is worth while.
Nesting find_nesting(const RenderScene& scene);

}  // namespace meniscus::tracer
