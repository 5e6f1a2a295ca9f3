#pragma once

#include <span>
#include <string>

#include "povray/writer.hpp"
#include "scene/object.hpp"

namespace meniscus::povray {

/// The object's shape where the scene puts it, complement included; `words` (each a line) stand
/// behind it in the same block.
void write_shape(Writer& writer, const scene::Object& object, std::span<const std::string> words);

/// How a transformation is written; empty for the identity.
std::string transformation(const geom::Transform& transform);

}  // namespace meniscus::povray
