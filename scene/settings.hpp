#pragma once

#include <optional>

#include "scene/color.hpp"
#include "scene/interior.hpp"
#include "scene/location.hpp"
#include "scene/working_space.hpp"

namespace meniscus::scene {

/// global_settings: what the scene states about rendering. Absent values are the renderer's to
/// choose.
struct Settings {
    std::optional<int> max_trace_level;  // POV-Ray's default is 5
    std::optional<double> adc_bailout;   // POV-Ray's default is 1/255
    Rgb ambient_light{1.0};
    Interior outside;                         // the medium of the space outside everything
    Location outside_location;                // where the scene says what that is
    std::optional<double> contact_tolerance;  // scene units, along the normal
    WorkingSpace working_space;               // of all colours; the picture is turned into light
    /// Values are written to the file as they are: no sRGB encoding. (Scenes below #version 3.7
    /// without assumed_gamma.)
    bool raw_output = false;
};

}  // namespace meniscus::scene
