#pragma once

#include <string>

#include "povray/export.hpp"
#include "scene/object.hpp"

namespace meniscus::povray {

/// The interior block of a solid: ior relative to the outside's, and absorption as media, which
/// POV-Ray applies on every way in the solid. Throws ExportError for fading that is no absorption,
/// except in Model::plain.
std::string interior(const scene::Solid& solid, const scene::Interior& outside, Model model);

}  // namespace meniscus::povray
