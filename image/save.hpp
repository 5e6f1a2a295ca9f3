#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "image/exr.hpp"
#include "image/file.hpp"
#include "image/png.hpp"

namespace meniscus::image {

enum class Format { png, exr };

/// By the file's extension, in any case; standard output is PNG.
std::optional<Format> format_of(const std::filesystem::path& path);

struct SaveOptions {
    Format format = Format::png;
    PngOptions png;
    ExrOptions exr;
};

/// All of the file or nothing; see `write_file`. Equal pictures and metadata give equal bytes.
void save(const Image& image, const std::filesystem::path& path, const SaveOptions& options,
          const Metadata& metadata);

/// A PNG or EXR file, told apart by what is in it, as linear values.
Image load(const std::filesystem::path& path);

/// A picture with what its file says of itself.
struct Loaded {
    Image image;
    Format format = Format::png;
    int bits = 8;  // a channel: 8 and 16 of integers, 16 and 32 of floats
    Metadata metadata;
};
Loaded load_with_header(const std::filesystem::path& path);

}  // namespace meniscus::image
