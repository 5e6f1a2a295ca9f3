#pragma once

#include <cmath>
#include <glm/common.hpp>
#include <utility>
#include <vector>

#include "tests/oracle/trace.hpp"

namespace meniscus::oracle {

/// How far the light at a pixel's centre moves, in each channel, if every ray of its tree runs
/// beside its place by up to `shift` and turned by up to `turn`: the sum, over all rays, of weight
/// times change. Each change is the exact one, of the whole tree that hangs on the ray, so that it
/// has in it what lies within reach of a jump.
template <class Real>
scene::Rgb movement(Tracer<Real>& oracle, int x, int y, int width, int height, double shift,
                    double turn) {
    using V = Vector<Real>;
    std::vector<typename Tracer<Real>::Branch> branches;
    oracle.record = &branches;
    oracle.pixel(x, y, width, height);
    oracle.record = nullptr;

    scene::Rgb sum{0.0};
    for (const auto& branch : branches) {
        const auto light = [&](const V& o, const V& d) {
            return oracle.radiance(o, d, branch.level, branch.weight, branch.straight_on);
        };
        const V d = branch.d;
        // So far ahead a ray that runs beside its place is still on the right side of the surface
        // that it comes from.
        const V o = branch.o + Real(1e3 * shift) * d;
        const scene::Rgb here = light(o, d);
        const Real ax = absolute(d.x), ay = absolute(d.y), az = absolute(d.z);
        const V least = ax <= ay && ax <= az ? V{1, 0, 0} : ay <= az ? V{0, 1, 0} : V{0, 0, 1};
        const V side = unit(cross(d, least)), up = cross(d, side);
        for (const V& aside : {side, up}) {
            const auto larger = [&](const scene::Rgb& a, const scene::Rgb& b) {
                return glm::max(glm::abs(a - here), glm::abs(b - here));
            };
            const V way = Real(shift) * aside, bend = Real(turn) * aside;
            sum += branch.weight * (larger(light(o + way, d), light(o - way, d)) +
                                    larger(light(o, unit(d + bend)), light(o, unit(d - bend))));
        }
    }
    return sum;
}

}  // namespace meniscus::oracle
