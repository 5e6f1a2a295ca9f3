#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace meniscus::lang {

/// How much a scene may ask for before it is taken for a mistake.
struct Limits {
    int nesting = 500;  // blocks, parentheses, objects in objects
    int include_depth = 100;
    int macro_depth = 500;
    std::size_t loop_steps = 10'000'000;  // in total, macro calls included
    std::size_t file_bytes = std::size_t{256} << 20;
    std::size_t string_bytes = std::size_t{1} << 20;
    std::size_t array_elements = 10'000'000;
    std::size_t objects = 2'000'000;
    double pigment_parts = 100'000;  // of one pigment
    std::size_t warnings = 200;      // the rest is counted only
};

/// What the command line says about reading a scene.
struct Options {
    std::vector<std::filesystem::path> library_paths;
    std::vector<std::pair<std::string, std::string>> declares;  // a number, else a text
    int image_width = 640, image_height = 480;
    bool allow_files = true;        // includes and meshes; not for untrusted text
    bool number_triangles = false;  // meshes remember their triangles' order, for findings
    Limits limits;
};

}  // namespace meniscus::lang
