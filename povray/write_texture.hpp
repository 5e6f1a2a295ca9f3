#pragma once

#include "povray/writer.hpp"
#include "scene/scene.hpp"

namespace meniscus::povray {

std::string color(const scene::Color& color);
std::string color(const scene::Rgb& rgb);

void write_pigment(Writer& writer, const scene::Pigment& pigment);
void write_texture(Writer& writer, const scene::Texture& texture);

}  // namespace meniscus::povray
