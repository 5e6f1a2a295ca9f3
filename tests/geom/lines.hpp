#pragma once

#include <random>
#include <vector>

#include "geom/bounds.hpp"
#include "geom/ray.hpp"

namespace meniscus::geom {

/// Numbers that are the same on every run and every machine.
class Dice {
public:
    explicit Dice(unsigned seed) : engine_(seed) {}

    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
    }
    int below(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }
    Vec3 point(double reach) {
        return {between(-reach, reach), between(-reach, reach), between(-reach, reach)};
    }
    Vec3 direction();
    /// A coordinate on a coarse grid: where edges, corners and tangents are.
    Vec3 lattice_point() {
        return {0.25 * (below(11) - 5), 0.25 * (below(11) - 5), 0.25 * (below(11) - 5)};
    }

private:
    std::mt19937 engine_;
};

/// Lines near the unit shapes: anywhere, along axes through grid points, and aimed at grid points.
std::vector<Ray> awkward_lines(int count, unsigned seed = 1);

}  // namespace meniscus::geom
