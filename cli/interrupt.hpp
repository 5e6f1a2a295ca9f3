#pragma once

#include <atomic>

namespace meniscus::cli {

/// While this lives, the first Ctrl-C sets `flag()`; another one, 0.2 s later or more, ends the
/// process as usual.
class InterruptGuard {
public:
    InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
    ~InterruptGuard();

    static const std::atomic<bool>& flag();
};

/// A reader that has gone away makes a write fail instead of ending the process.
void ignore_broken_pipes();

}  // namespace meniscus::cli
