#pragma once

#include <algorithm>

#include "geom/crossing.hpp"
#include "geom/inline_vector.hpp"

namespace meniscus::geom {

/// A place where a line may cross a surface.
struct Candidate {
    double t;
    Face face;
};
using Candidates = InlineVector<Candidate, 16>;

/// Keeps those candidates at which the line changes sides, as `inside(t)` tells between them:
/// whatever numerical root finding missed, doubled or invented, entering and leaving take turns and
/// balance. Candidates within `merge` of each other are one.
template <class Inside>
void keep_changes(Candidates& candidates, double merge, Inside&& inside, Crossings& out) {
    std::sort(candidates.begin(), candidates.end(),
              [](const Candidate& a, const Candidate& b) { return a.t < b.t; });
    bool is_inside = false;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const Candidate& candidate = candidates[i];
        while (i + 1 < candidates.size() && candidates[i + 1].t - candidate.t <= merge) ++i;
        const bool was_inside = is_inside;
        is_inside = i + 1 < candidates.size() &&
                    inside(candidates[i].t + 0.5 * (candidates[i + 1].t - candidates[i].t));
        if (is_inside != was_inside) out.push_back({candidate.t, candidate.face, is_inside});
    }
}

}  // namespace meniscus::geom
