#pragma once

#include <array>
#include <vector>

namespace meniscus::tracer {

struct RenderScene;

/// What a ray may meet before it has left a solid that it is in: what comes near that one's bounds.
/// For a bubble in a block that is the block alone, whatever else the scene has.
struct Neighbours {
    static constexpr int most = 6;
    static constexpr int unknown = -1;
    struct Near {
        int count = unknown;  // of parts; unknown: more than those, or nothing a ray can be in
        std::array<int, most> parts{};
    };

    std::vector<Near> near;  // by part
    double margin = 0.0;     // nothing else comes nearer
};

Neighbours find_neighbours(const RenderScene& scene);

}  // namespace meniscus::tracer
