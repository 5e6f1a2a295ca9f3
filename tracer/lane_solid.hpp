#pragma once

#include "lanes/program.hpp"
#include "tracer/render_scene.hpp"

namespace meniscus::tracer {

/// A part as lanes meet it: by code of their own, or by asking the host.
lanes::Solid make_lane_solid(const Part& part, int index);

/// The radius of a sphere around a box, with a margin for rounding.
double sphere_around(const geom::Bounds& bounds, const geom::Vec3& middle);

}  // namespace meniscus::tracer
