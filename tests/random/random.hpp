#pragma once

#include <cmath>
#include <cstdint>

#include "geom/vec.hpp"

namespace meniscus {

/// For scenes that chance makes: splitmix64 (Steele, Lea and Flood 2014): the same numbers on every
/// machine.
class Random {
public:
    /// One step takes neighbouring seeds, whose sequences would overlap, far apart.
    explicit Random(std::uint64_t seed) : state_(seed) { state_ = next(); }
    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    /// In [0, n).
    int below(int n) { return int(next() % std::uint64_t(n)); }
    double between(double low, double high) {
        return low + (high - low) * (double(next() >> 11) * 0x1p-53);
    }
    bool chance(double p) { return between(0.0, 1.0) < p; }
    /// A multiple of one half.
    double lattice(double low, double high) {
        return low + 0.5 * below(int((high - low) * 2.0) + 1);
    }
    geom::Vec3 lattice_point(double low, double high) {
        const double x = lattice(low, high), y = lattice(low, high), z = lattice(low, high);
        return {x, y, z};
    }
    geom::Vec3 point(double low, double high) {
        const double x = between(low, high), y = between(low, high), z = between(low, high);
        return {x, y, z};
    }
    /// Of that length along one of the axes.
    static geom::Vec3 along(int axis, double length) {
        geom::Vec3 result{0.0};
        result[axis] = length;
        return result;
    }
    /// Uniform over the unit sphere.
    geom::Vec3 direction() {
        const double z = between(-1.0, 1.0), angle = between(-std::acos(-1.0), std::acos(-1.0));
        const double r = std::sqrt(1.0 - z * z);
        return {r * std::cos(angle), r * std::sin(angle), z};
    }

private:
    std::uint64_t state_;
};

}  // namespace meniscus
