#pragma once

#include <cstdint>

#include "geom/vec.hpp"
#include "lanes/chance.hpp"

namespace meniscus::tracer {

using lanes::mix;

/// Point `index` of an Owen-scrambled Sobol set in [0, 1)^2, a function of index and seed only
/// (Burley 2020).
geom::Vec2 sobol_point(std::uint32_t index, std::uint64_t seed);

}  // namespace meniscus::tracer
