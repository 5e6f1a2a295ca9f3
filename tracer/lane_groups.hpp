#pragma once

#include <vector>

#include "lanes/program.hpp"

namespace meniscus::tracer {

/// Puts the spheres at these ranks into groups.
void group_small_spheres(std::vector<int> ranks, lanes::Program& program);

}  // namespace meniscus::tracer
