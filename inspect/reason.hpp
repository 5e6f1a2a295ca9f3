#pragma once

#include <string>

#include "inspect/replay.hpp"

namespace meniscus::inspect {

/// Why a crossing is false: what is there does not change.
std::string why_false(const tracer::RenderScene& scene, const Names& names,
                      const tracer::Judged& crossing, const Step& step);

/// Why a crossing is true: `event` is what it is a part of.
std::string why_true(const tracer::RenderScene& scene, const Names& names,
                     const tracer::Judged& crossing, const Step& step, const tracer::Event& event);

}  // namespace meniscus::inspect
