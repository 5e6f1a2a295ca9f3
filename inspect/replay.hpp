#pragma once

#include <span>
#include <string>
#include <vector>

#include "inspect/listing.hpp"
#include "tracer/options.hpp"
#include "tracer/ray_tree.hpp"

namespace meniscus::inspect {

/// One place where a ray crosses surfaces: one crossing, or several that coincide and are applied
/// to the list together.
struct Step {
    std::vector<tracer::Judged> crossings;
    bool is_true = false;
    Listing before, after;
    std::vector<std::string> why;  // for each crossing
};

/// The list, step by step along one segment: its recorded crossings applied again to the list that
/// it started with.
std::vector<Step> replay(const tracer::RenderScene& scene, const Names& names,
                         const tracer::TreeNode& node, tracer::InteriorMode mode);

}  // namespace meniscus::inspect
