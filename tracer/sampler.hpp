#pragma once

#include <cstdint>

#include "geom/vec.hpp"
#include "lanes/chance.hpp"

namespace meniscus::tracer {

using lanes::mix;

/// An Owen-scrambled Sobol set in [0, 1)^2, its points shuffled within it: a function of the seed
/// only (Burley 2020).
class SobolSet {
public:
    explicit SobolSet(std::uint64_t seed);
    geom::Vec2 point(std::uint32_t index) const;

private:
    std::uint32_t order_, first_, second_;  // seeds of the shuffling and of the two dimensions
};

}  // namespace meniscus::tracer
