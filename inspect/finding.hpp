#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geom/vec.hpp"
#include "scene/location.hpp"

namespace meniscus::inspect {

/// Something about a scene that will go wrong, or that one should know. Notes do not count as
/// findings of `check`.
struct Finding {
    enum class Severity { warning, note };
    struct Related {
        scene::Location location;
        std::string text;
    };

    Severity severity = Severity::warning;
    std::string lint;  // the rule's name, as "equal-priority-overlap"
    scene::Location location;
    std::string text;
    std::string advice;                                 // what to do
    std::vector<Related> related;                       // other places that belong to it
    std::optional<geom::Vec3> position = std::nullopt;  // in the scene, if it is in one place
    std::optional<double> depth =
        std::nullopt;                           // of an overlap, or the width of a gap: scene units
    std::vector<std::uint32_t> triangles = {};  // of a mesh, which it is about: counted from 0
};

/// "2 warnings, 1 note".
std::string summary(const std::vector<Finding>& findings);

bool has_warnings(const std::vector<Finding>& findings);

}  // namespace meniscus::inspect
