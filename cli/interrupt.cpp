#include "cli/interrupt.hpp"

#include <csignal>
#include <cstdint>
#include <ctime>

namespace meniscus::cli {
namespace {

constexpr std::int64_t never = -1;

std::atomic<bool> interrupted = false;
std::atomic<std::int64_t> first_at = never;  // ms
static_assert(std::atomic<bool>::is_always_lock_free &&
                  std::atomic<std::int64_t>::is_always_lock_free,
              "a signal handler sets them");

std::int64_t milliseconds() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return std::int64_t{now.tv_sec} * 1000 + now.tv_nsec / 1'000'000;
}

// `timeout` and shells send one interrupt twice, to the process and to its group: what comes at
// once is the same one.
void on_interrupt(int signal) {
    const auto now = milliseconds();
    auto first = never;
    if (first_at.compare_exchange_strong(first, now)) {
        interrupted = true;
    } else if (now - first >= 200) {
        std::signal(SIGINT, SIG_DFL);
        std::raise(signal);
    }
}

}  // namespace

InterruptGuard::InterruptGuard() {
    interrupted = false;
    first_at = never;
    std::signal(SIGINT, on_interrupt);
}

InterruptGuard::~InterruptGuard() { std::signal(SIGINT, SIG_DFL); }

const std::atomic<bool>& InterruptGuard::flag() { return interrupted; }

void ignore_broken_pipes() { std::signal(SIGPIPE, SIG_IGN); }

}  // namespace meniscus::cli
