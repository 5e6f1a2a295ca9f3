#pragma once

#include <string>

namespace meniscus::scene {

/// Where in a scene's text a thing was declared: 1-based line and column (in bytes).
struct Location {
    std::string file;
    int line = 0;
    int column = 0;
};

}  // namespace meniscus::scene
