#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace meniscus::povray {

/// Where a program runs and where its words go.
struct ProcessPlace {
    std::filesystem::path folder;          // its working directory
    std::filesystem::path output, errors;  // files for its standard output and error
};

/// Runs a program found in the search path, without a shell, with an empty standard input, and
/// waits for it. Its exit status (128 + n if signal n ended it), or nothing if there is no such
/// program.
std::optional<int> run_process(const std::vector<std::string>& command, const ProcessPlace& place);

}  // namespace meniscus::povray
