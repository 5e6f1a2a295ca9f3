#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace meniscus::povray {

/// What stands for the priorities, which POV-Ray does not know.
enum class Model {
    plain,    // nothing: as declared
    contact,  // solids that overlap by a hair, and cut faces that reflect nothing: the nested
              // picture itself
    gap       // each solid minus its higher neighbours made larger: films of the outside between
};

struct ExportOptions {
    Model model = Model::contact;
    double gap = 0.0;             // scene units; Model::gap alone
    std::optional<double> scale;  // exported units in a scene unit; default: by the scene's size
    std::string source;           // what the scene is called, for the head
};

struct Exported {
    std::string text;
    double scale = 1.0;
    double overlap = 0.0;               // contact: the least, in scene units
    std::vector<std::string> warnings;  // where the picture may not be exact
};

/// A scene in POV-Ray's own language. Throws ExportError for what the model cannot say.
Exported export_scene(const scene::Scene& scene, const ExportOptions& options);

}  // namespace meniscus::povray
