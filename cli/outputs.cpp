#include "cli/outputs.hpp"

#include <fmt/format.h>

#include <system_error>

#include "cli/exit_code.hpp"
#include "image/file.hpp"

namespace meniscus::cli {
namespace {

namespace fs = std::filesystem;

/// One regular file under two names, or one name that may not exist yet.
bool are_one(const fs::path& a, const fs::path& b) {
    std::error_code unknown;
    if (fs::equivalent(a, b, unknown)) return fs::is_regular_file(a, unknown);
    const auto absolute = [&](const fs::path& p) {
        return fs::weakly_canonical(fs::absolute(p, unknown), unknown);
    };
    return !fs::exists(a, unknown) && !fs::exists(b, unknown) && absolute(a) == absolute(b);
}

}  // namespace

void check_outputs(const std::vector<std::string>& outputs, const std::vector<fs::path>& inputs) {
    std::vector<fs::path> files;
    for (const auto& output : outputs) {
        if (output.empty() || output == image::standard_stream) continue;
        for (const auto& input : inputs)
            if (are_one(output, input))
                throw UsageError(fmt::format(
                    "'{}' is read here: writing would destroy it; give another file", output));
        for (const auto& other : files)
            if (are_one(output, other))
                throw UsageError(
                    fmt::format("'{}' would be written twice; give another file", output));
        image::check_writable(output);
        files.emplace_back(output);
    }
}

}  // namespace meniscus::cli
