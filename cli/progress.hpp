#pragma once

#include <chrono>
#include <cstdio>
#include <string>

namespace meniscus::cli {

bool is_terminal(std::FILE* stream);

/// "12 s", "3:05", "1:02:03".
std::string format_seconds(double seconds);

/// Shows the finished share on standard error: a bar with the time left on a terminal, a line each
/// 10 % elsewhere.
class Progress {
public:
    Progress();
    void show(double share);
    /// Clears the bar; work that is done early is at 100 % all the same.
    void finish(bool done);

private:
    using Clock = std::chrono::steady_clock;
    void show_bar(double share);
    void show_line(double share);

    bool terminal_;
    Clock::time_point start_, last_bar_;
    bool bar_shown_ = false;
    int tenths_ = 0;
};

}  // namespace meniscus::cli
