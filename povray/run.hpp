#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "image/image.hpp"

namespace meniscus::povray {

/// How POV-Ray is to render. The defaults sample pixel centres in one thread.
struct RunOptions {
    int width = 640, height = 480;
    std::vector<std::string> antialiasing = {"-A"};  // as {"+A0.0", "+AM2", "+R3", "-J"}
    std::vector<std::pair<std::string, std::string>> declares = {};  // Declare=NAME=VALUE
    std::vector<std::filesystem::path> library_paths = {};           // +L
    int threads = 1;
};

/// What came of it.
struct Run {
    image::Image picture;                     // linear, clipped to [0, 1], in steps of 1/65535
    double seconds = 0.0, cpu_seconds = 0.0;  // of its trace stage alone, to 1 ms
    std::vector<std::string> warnings;        // its own words, one line each
    std::vector<std::string> command;         // what was run
};

/// There is no `povray` to run; the message says how to get it.
struct NotInstalled : std::runtime_error {
    NotInstalled();
};

/// POV-Ray does not render the scene; the message ends with its own words.
struct RunFailed : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Runs the installed POV-Ray 3.7 on a scene file, in the file's folder.
Run run(const std::filesystem::path& scene, const RunOptions& options = {});

/// The same for a text at hand.
Run run_text(std::string_view scene, const RunOptions& options = {});

}  // namespace meniscus::povray
