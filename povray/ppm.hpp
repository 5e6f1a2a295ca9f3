#pragma once

#include <string>

#include "image/image.hpp"

namespace meniscus::povray {

/// A binary PPM of 16 bits whose values are linear. Throws std::runtime_error for anything else.
image::Image read_ppm(const std::string& bytes);

}  // namespace meniscus::povray
