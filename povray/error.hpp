#pragma once

#include <stdexcept>
#include <string>

#include "scene/location.hpp"

namespace meniscus::povray {

/// A scene, or one object of it, that the chosen model cannot say exactly: where, why, and what to
/// do.
struct ExportError : std::runtime_error {
    ExportError(scene::Location where, const std::string& why)
        : std::runtime_error(why), location(std::move(where)) {}
    scene::Location location;
};

}  // namespace meniscus::povray
