#pragma once

#include <string>
#include <string_view>

#include "image/color.hpp"
#include "image/image.hpp"

namespace meniscus::image {

struct PngOptions {
    int bits = 8;  // or 16
    Encoding encoding = Encoding::srgb;
};

/// The whole picture, black outside the image's window. Layers are left out: PNG has no place for
/// them.
std::string encode_png(const Image& image, const PngOptions& options, const Metadata& metadata);

/// Linear values, by what the file says of its encoding (sRGB where it says nothing). Transparency
/// is ignored.
Image decode_png(std::string_view bytes);

/// What stands before the pixels.
struct PngHeader {
    int bits = 8;  // a channel
    Metadata metadata;
};
PngHeader decode_png_header(std::string_view bytes);

}  // namespace meniscus::image
