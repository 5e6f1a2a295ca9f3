#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace meniscus::cli {

/// Throws UsageError where one of the files to be written is also read, or would be written twice,
/// and FileError where it cannot be written. Empty names and "-" are passed over.
void check_outputs(const std::vector<std::string>& outputs,
                   const std::vector<std::filesystem::path>& inputs);

}  // namespace meniscus::cli
