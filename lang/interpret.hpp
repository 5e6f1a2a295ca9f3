#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lang/diagnostic.hpp"
#include "lang/options.hpp"
#include "lang/unused_objects.hpp"
#include "scene/scene.hpp"

namespace meniscus::lang {

/// A scene file, understood.
struct Interpreted {
    scene::Scene scene;
    std::vector<Diagnostic> warnings;
    std::string messages;                      // what #debug and its like print
    std::vector<UnusedObject> unused_objects;  // of the scene file itself, not of what it includes
    std::vector<std::filesystem::path> files;  // that were read, of any kind
};

/// Reads a scene file and all that it includes. Throws SourceError, and FileError if a file cannot
/// be read.
Interpreted interpret_file(const std::filesystem::path& path, const Options& options = {});

/// The same for a text at hand; `name` stands for the file in messages.
Interpreted interpret_text(std::string name, std::string text, const Options& options = {});

}  // namespace meniscus::lang
