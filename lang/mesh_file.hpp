#pragma once

#include <filesystem>
#include <string>

#include "geom/triangle_mesh.hpp"

// Readers of mesh files, one for each format. All throw std::runtime_error with a sentence that
// names the file.
namespace meniscus::lang {

/// Wavefront .obj.
geom::TriangleSoup load_obj(const std::filesystem::path& path);
/// Stanford's .ply, as text or binary of either byte order; numbers keep all of their digits.
geom::TriangleSoup load_ply(const std::filesystem::path& path);
/// Any format that Assimp knows.
geom::TriangleSoup load_by_assimp(const std::filesystem::path& path);

[[noreturn]] void fail_to_load(const std::filesystem::path& path, const std::string& reason);
std::string first_line(std::string text);
std::string lower_extension(const std::filesystem::path& path);

}  // namespace meniscus::lang
