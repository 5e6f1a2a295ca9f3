#include "benchmarks/bumpy_ring.hpp"

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>

namespace meniscus::geom {

TriangleSoup bumpy_ring(std::size_t triangles) {
    const int across = std::max(3, static_cast<int>(std::lround(std::sqrt(triangles / 4.0))));
    const int around = std::max(3, static_cast<int>(std::lround(triangles / 2.0 / across)));
    TriangleSoup soup;
    const auto vertex = [&](int i, int j) {
        return static_cast<std::uint32_t>((i % around) * across + j % across);
    };
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < across; ++j) {
            const double a = 2.0 * std::numbers::pi * i / around;
            const double b = 2.0 * std::numbers::pi * j / across;
            const double minor = 0.35 + 0.03 * std::sin(9.0 * a) * std::cos(5.0 * b);
            const double radius = 0.65 + minor * std::cos(b);
            soup.positions.push_back(
                {radius * std::cos(a), minor * std::sin(b), radius * std::sin(a)});
            soup.triangles.push_back({vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1)});
            soup.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i + 1, j)});
        }
    }
    return soup;
}

void write(const TriangleSoup& soup, const std::filesystem::path& path) {
    std::ofstream file(path, std::ios::binary);
    const auto put = [&](const auto& value) {
        file.write(reinterpret_cast<const char*>(&value), sizeof value);
    };
    if (path.extension() == ".obj") {
        file.precision(9);
        for (const Vec3& p : soup.positions)
            file << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
        for (const auto& [a, b, c] : soup.triangles)
            file << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
    } else if (path.extension() == ".ply") {
        file << "ply\nformat binary_little_endian 1.0\nelement vertex " << soup.positions.size()
             << "\nproperty float x\nproperty float y\nproperty float z\nelement face "
             << soup.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
        for (const Vec3& p : soup.positions) {
            for (int i = 0; i < 3; ++i) put(static_cast<float>(p[i]));
        }
        for (const TriangleIndices& triangle : soup.triangles) {
            put(std::uint8_t{3});
            for (const std::uint32_t corner : triangle) put(corner);
        }
    } else {
        file << std::string(80, ' ');
        put(static_cast<std::uint32_t>(soup.triangles.size()));
        for (const TriangleIndices& triangle : soup.triangles) {
            for (int i = 0; i < 3; ++i) put(0.0f);
            for (const std::uint32_t corner : triangle) {
                for (int i = 0; i < 3; ++i) put(static_cast<float>(soup.positions[corner][i]));
            }
            put(std::uint16_t{0});
        }
    }
}

}  // namespace meniscus::geom
