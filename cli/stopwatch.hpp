#pragma once

#include <chrono>
#include <cstdint>

namespace meniscus::cli {

/// Seconds by the clock and of all threads together.
struct Duration {
    double wall = 0.0, cpu = 0.0;
};

class Stopwatch {
public:
    Stopwatch();
    /// Since the last lap or the start.
    Duration lap();

private:
    std::chrono::steady_clock::time_point wall_;
    double cpu_;
};

/// The most memory that this process has held.
std::uint64_t peak_bytes();

}  // namespace meniscus::cli
