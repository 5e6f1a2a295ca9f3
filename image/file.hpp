#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace meniscus::image {

/// A file cannot be read or written; the message names it and says why.
struct FileError : std::runtime_error {
    FileError(const std::filesystem::path& path, std::string_view why);
    std::filesystem::path path;
};

/// The path that stands for standard input or output.
inline constexpr std::string_view standard_stream = "-";

std::string read_file(const std::filesystem::path& path);

/// All of it or nothing: written under a temporary name beside the target, then renamed. What is
/// not a regular file (a device, a pipe, "-") is written straight.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// Throws what `write_file` would, as far as that can be known without writing; nothing is left
/// behind.
void check_writable(const std::filesystem::path& path);

}  // namespace meniscus::image
