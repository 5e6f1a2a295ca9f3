#pragma once

#include <string>
#include <string_view>

#include "image/image.hpp"

namespace meniscus::image {

struct ExrOptions {
    bool half = false;  // colours in 16-bit floats; layers are always 32-bit
};

/// Linear values; the data window is the image's window, layers are channels of their own.
std::string encode_exr(const Image& image, const ExrOptions& options, const Metadata& metadata);

/// Channels R, G, B (or Y alone) are the colours, all others layers.
Image decode_exr(std::string_view bytes);

/// What stands before the pixels.
struct ExrHeader {
    bool half = false;  // some colour is in 16-bit floats
    Metadata metadata;
};
ExrHeader decode_exr_header(std::string_view bytes);

}  // namespace meniscus::image
