#include "cli/stopwatch.hpp"

#include <sys/resource.h>

#include <ctime>

namespace meniscus::cli {
namespace {

double process_cpu_seconds() {
    timespec time{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

}  // namespace

Stopwatch::Stopwatch() : wall_(std::chrono::steady_clock::now()), cpu_(process_cpu_seconds()) {}

Duration Stopwatch::lap() {
    const Stopwatch now;
    const Duration duration{std::chrono::duration<double>(now.wall_ - wall_).count(),
                            now.cpu_ - cpu_};
    *this = now;
    return duration;
}

std::uint64_t peak_bytes() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return std::uint64_t(usage.ru_maxrss) * 1024;
}

}  // namespace meniscus::cli
