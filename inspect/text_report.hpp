#pragma once

#include <string>

#include "inspect/pixel_trace.hpp"

namespace meniscus::inspect {

/// The ray tree in words: a paragraph for each segment, indented by what led to it.
std::string format_text(const tracer::RenderScene& scene, const Names& names,
                        const PixelTrace& trace);

/// "camera ray", "reflected", "refracted" or "straight on".
std::string_view name(tracer::TreeNode::Branch branch);

}  // namespace meniscus::inspect
