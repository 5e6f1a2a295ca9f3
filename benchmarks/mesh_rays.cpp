// mesh_rays TRIANGLES [RAYS [REPEATS]]: rays against a closed mesh of about so many triangles, ours
// and Embree's alternately, one ray at a time, and sixteen of ours in turns; one thread.
// mesh_rays --write TRIANGLES FILE.obj|.ply|.stl only writes the mesh.
#include <embree3/rtcore.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "benchmarks/bumpy_ring.hpp"
#include "benchmarks/known_rays.hpp"

namespace {

using namespace meniscus::geom;

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
    std::vector<double> our_times, times_in_turns, their_times;
    std::size_t our_hits = 0, hits_in_turns = 0, their_hits = 0;
    double our_sum = 0.0, their_sum = 0.0;
    Crossings found;
    InTurns in_turns;
    for (int repeat = 0; repeat < repeats; ++repeat) {
        our_hits = hits_in_turns = their_hits = 0;
        our_sum = their_sum = 0.0;
        our_times.push_back(cpu_seconds([&] {
            for (const KnownRay& ray : rays) {
                const double t = nearest(ours, ray, found).t;
                if (t < infinity) ++our_hits, our_sum += t;
            }
        }));
        times_in_turns.push_back(cpu_seconds([&] {
            for (std::span<const KnownRay> left(rays); !left.empty();) {
                const auto some = left.first(std::min(left.size(), InTurns::most));
                Nearest met[InTurns::most];
                in_turns.nearest(ours, some, met);
                for (std::size_t i = 0; i < some.size(); ++i) hits_in_turns += met[i].t < infinity;
                left = left.subspan(some.size());
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
    const double us = mrays / median(our_times), turns = mrays / median(times_in_turns),
                 them = mrays / median(their_times);
    std::printf(
        "%-12s %8.2f Mrays/s, Embree %8.2f: %5.2fx   in turns %8.2f: %5.2fx   hits %zu, %zu, %zu"
        "   mean t %.6f, %.6f\n",
        name, us, them, us / them, turns, turns / them, our_hits, hits_in_turns, their_hits,
        our_sum / static_cast<double>(our_hits), their_sum / static_cast<double>(their_hits));
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
