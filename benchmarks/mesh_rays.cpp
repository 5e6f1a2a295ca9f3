// mesh_rays TRIANGLES [RAYS [REPEATS]]: rays against a closed mesh of about so many triangles, ours
// and Embree's in turns, one ray at a time, on one thread. mesh_rays --write TRIANGLES
// FILE.obj|.ply|.stl only writes the mesh.
#include <embree3/rtcore.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "geom/triangle_mesh.hpp"

namespace {

using namespace meniscus::geom;

/// A ring with bumps, about the y axis: no two triangles are alike.
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

class Stopwatch {
public:
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::size_t resident_bytes() {
    std::ifstream status("/proc/self/statm");
    std::size_t all = 0, resident = 0;
    status >> all >> resident;
    return resident * 4096;
}

/// A ray as the tracer has it: it knows how deep it is inside, and the face that it was born on.
struct KnownRay {
    Ray ray;
    int depth = 0;
    Face born_on = no_face;
};

struct Nearest {
    double t = infinity;
    Face face = no_face;
};

Nearest nearest(const TriangleMesh& mesh, const KnownRay& known, Crossings& found) {
    found.clear();
    const Search search{.from = 0.0,
                        .entering_ends = true,
                        .leaving_ends = true,
                        .slack = 1e-7,
                        .slack_per_t = 1e-7,
                        .own = known.born_on};
    if (!mesh.crossings_ahead(known.ray, search, known.depth, found)) {
        found.clear();
        mesh.crossings(known.ray, found);
    }
    for (const Crossing& crossing : found) {
        if (crossing.t > 0.0 && crossing.face != known.born_on) return {crossing.t, crossing.face};
    }
    return {};
}

struct EmbreeMesh {
    explicit EmbreeMesh(const TriangleSoup& soup) {
        device = rtcNewDevice("threads=1,hugepages=1");
        scene = rtcNewScene(device);
        rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
        rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* positions = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, soup.positions.size()));
        for (const Vec3& p : soup.positions) {
            for (int i = 0; i < 3; ++i) *positions++ = static_cast<float>(p[i]);
        }
        auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, soup.triangles.size()));
        for (const TriangleIndices& triangle : soup.triangles)
            indices = std::copy(triangle.begin(), triangle.end(), indices);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene);
    }
    ~EmbreeMesh() {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }

    double nearest(const KnownRay& known) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit query{};
        query.ray.org_x = static_cast<float>(known.ray.origin.x);
        query.ray.org_y = static_cast<float>(known.ray.origin.y);
        query.ray.org_z = static_cast<float>(known.ray.origin.z);
        query.ray.dir_x = static_cast<float>(known.ray.direction.x);
        query.ray.dir_y = static_cast<float>(known.ray.direction.y);
        query.ray.dir_z = static_cast<float>(known.ray.direction.z);
        query.ray.tnear = 1e-4f;
        query.ray.tfar = std::numeric_limits<float>::infinity();
        query.ray.mask = 0xffffffff;
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene, &context, &query);
        return query.hit.geomID == RTC_INVALID_GEOMETRY_ID ? infinity : query.ray.tfar;
    }

    RTCDevice device;
    RTCScene scene;
};

class Random {
public:
    double next() { return static_cast<double>(engine_()) / 4294967296.0; }
    Vec3 direction() {
        const double z = 2.0 * next() - 1.0, a = 2.0 * std::numbers::pi * next();
        const double r = std::sqrt(1.0 - z * z);
        return {r * std::cos(a), r * std::sin(a), z};
    }

private:
    std::mt19937 engine_{7};
};

Ray camera_ray(int i, int width) {
    const double x = (i % width + 0.5) / width - 0.5, y = 0.5 - (i / width + 0.5) / width;
    return {{0.3, 2.2, -2.6}, glm::normalize(Vec3{1.1 * x - 0.1, 1.1 * y - 0.85, 1.0})};
}

std::vector<KnownRay> primary_rays(int count) {
    const int width = static_cast<int>(std::sqrt(count));
    std::vector<KnownRay> rays;
    for (int i = 0; i < width * width; ++i) rays.push_back({camera_ray(i, width)});
    return rays;
}

/// Where a ray arrives, as the origin of the next.
Ray arrived(const TriangleMesh& mesh, const Ray& ray, const Nearest& hit) {
    Ray next{ray.at(hit.t), {}};
    next.origin_error = mesh.to_face(hit.face, next);
    return next;
}

/// From the surface inwards, in any direction.
std::vector<KnownRay> diffuse_rays(const TriangleMesh& mesh, int count) {
    Random random;
    Crossings found;
    std::vector<KnownRay> rays;
    const int width = static_cast<int>(std::sqrt(count));
    while (static_cast<int>(rays.size()) < count) {
        const KnownRay camera{camera_ray(static_cast<int>(random.next() * width * width), width)};
        const Nearest hit = nearest(mesh, camera, found);
        if (hit.face == no_face) continue;
        KnownRay inwards{arrived(mesh, camera.ray, hit), 1, hit.face};
        inwards.ray.direction = random.direction();
        if (glm::dot(inwards.ray.direction, mesh.normal(hit.face)) > 0.0)
            inwards.ray.direction *= -1.0;
        rays.push_back(inwards);
    }
    return rays;
}

/// All segments of paths that refract or reflect, by chance, at a glass of index 1.5.
std::vector<KnownRay> glass_chain(const TriangleMesh& mesh, int count) {
    Random random;
    Crossings found;
    std::vector<KnownRay> rays;
    const int width = static_cast<int>(std::sqrt(count));
    while (static_cast<int>(rays.size()) < count) {
        KnownRay known{camera_ray(static_cast<int>(random.next() * width * width), width)};
        for (int segment = 0; segment < 16; ++segment) {
            rays.push_back(known);
            const Nearest hit = nearest(mesh, known, found);
            if (hit.face == no_face) break;
            const Vec3 d = known.ray.direction;
            Vec3 n = mesh.normal(hit.face);
            if (glm::dot(n, d) > 0.0) n = -n;
            const double eta = known.depth > 0 ? 1.5 : 1.0 / 1.5, ci = -glm::dot(n, d);
            const double st2 = eta * eta * (1.0 - ci * ci),
                         ct = std::sqrt(std::max(0.0, 1.0 - st2));
            const double rs = (eta * ci - ct) / (eta * ci + ct),
                         rp = (ci - eta * ct) / (ci + eta * ct);
            const bool reflects = st2 >= 1.0 || random.next() < 0.5 * (rs * rs + rp * rp);
            known.ray = arrived(mesh, known.ray, hit);
            known.ray.direction =
                glm::normalize(reflects ? d + 2.0 * ci * n : eta * d + (eta * ci - ct) * n);
            known.born_on = hit.face;
            if (!reflects) known.depth = 1 - known.depth;
        }
    }
    rays.resize(static_cast<std::size_t>(count));
    return rays;
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    return values[values.size() / 2];
}

double cpu_seconds(const std::function<void()>& work) {
    const auto now = [] {
        timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    };
    const double start = now();
    work();
    return now() - start;
}

void compare(const char* name, const TriangleMesh& ours, const EmbreeMesh& theirs,
             const std::vector<KnownRay>& rays, int repeats) {
    std::vector<double> our_times, their_times;
    std::size_t our_hits = 0, their_hits = 0;
    double our_sum = 0.0, their_sum = 0.0;
    Crossings found;
    for (int repeat = 0; repeat < repeats; ++repeat) {
        our_hits = their_hits = 0;
        our_sum = their_sum = 0.0;
        our_times.push_back(cpu_seconds([&] {
            for (const KnownRay& ray : rays) {
                const double t = nearest(ours, ray, found).t;
                if (t < infinity) ++our_hits, our_sum += t;
            }
        }));
        their_times.push_back(cpu_seconds([&] {
            for (const KnownRay& ray : rays) {
                const double t = theirs.nearest(ray);
                if (t < infinity) ++their_hits, their_sum += t;
            }
        }));
    }
    const double mrays = 1e-6 * static_cast<double>(rays.size());
    const double us = mrays / median(our_times), them = mrays / median(their_times);
    std::printf("%-12s %8.2f Mrays/s, Embree %8.2f: %5.2fx   hits %zu, %zu   mean t %.6f, %.6f\n",
                name, us, them, us / them, our_hits, their_hits,
                our_sum / static_cast<double>(our_hits),
                their_sum / static_cast<double>(their_hits));
}

}  // namespace

int main(int argc, char** argv) {
    if (argc == 4 && !std::strcmp(argv[1], "--write")) {
        write(bumpy_ring(std::strtoul(argv[2], nullptr, 10)), argv[3]);
        return 0;
    }
    const std::size_t triangles = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 70000;
    const int count = argc > 2 ? std::atoi(argv[2]) : 262144;
    const int repeats = argc > 3 ? std::atoi(argv[3]) : 5;

    TriangleSoup soup = bumpy_ring(triangles);
    // Both hold the same numbers: Embree knows only floats. (Through memory: g++ 12 at -O3 forgets
    // to round where it converts to float and back in vectors.)
    for (Vec3& p : soup.positions) {
        for (int i = 0; i < 3; ++i) {
            const volatile float rounded = static_cast<float>(p[i]);
            p[i] = rounded;
        }
    }
    const bool keep_double = std::getenv("MESH_RAYS_DOUBLE") != nullptr;
    TriangleSoup copy = soup;
    if (keep_double) copy.positions[0].x += 1e-12;  // one coordinate that is no float
    const std::size_t before = resident_bytes();
    const Stopwatch watch;
    const TriangleMesh ours(std::move(copy));
    const double seconds = watch.seconds();
    std::printf(
        "%zu triangles: built in %.3f s (%.2f Mtri/s), %.1f bytes a triangle counted, %.1f "
        "resident\n",
        ours.size(), seconds, 1e-6 * static_cast<double>(ours.size()) / seconds,
        static_cast<double>(ours.memory_bytes()) / static_cast<double>(ours.size()),
        static_cast<double>(resident_bytes() - before) / static_cast<double>(ours.size()));
    const Stopwatch embree_watch;
    const EmbreeMesh theirs(soup);
    std::printf("Embree: built in %.3f s\n", embree_watch.seconds());

    compare("primary", ours, theirs, primary_rays(count), repeats);
    compare("diffuse", ours, theirs, diffuse_rays(ours, count), repeats);
    compare("glass chain", ours, theirs, glass_chain(ours, count), repeats);
}
