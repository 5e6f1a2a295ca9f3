#pragma once

#include <string>

#include "image/image.hpp"

namespace meniscus::compare {

/// Both pictures' values in every bit, small: the bytes of all 32-bit floats (little-endian), first
/// all lowest bytes, then all next ones and so on, of the reference and then of the bitwise
/// difference of the picture from it, compressed as RFC 1950 (zlib). Pictures of one size.
std::string pack(const image::Image& reference, const image::Image& picture);

}  // namespace meniscus::compare
