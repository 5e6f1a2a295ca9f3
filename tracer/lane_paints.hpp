#pragma once

#include "lanes/program.hpp"
#include "tracer/render_scene.hpp"

namespace meniscus::tracer {

const scene::Texture& texture_of(const RenderScene& scene, const Part& part);

/// Surfaces that lanes can shade, if they can follow all lights.
void make_paints(const RenderScene& scene, lanes::Program& program);

}  // namespace meniscus::tracer
