#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

namespace meniscus::cli {
namespace {

constexpr int bar_width = 40;
constexpr auto bar_interval = std::chrono::milliseconds(100);

}  // namespace

bool is_terminal(std::FILE* stream) { return ::isatty(::fileno(stream)) == 1; }

std::string format_seconds(double seconds) {
    const auto whole = long(std::clamp(seconds, 0.0, 1e9) + 0.5);
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

Progress::Progress() : terminal_(is_terminal(stderr)), start_(Clock::now()), last_bar_(start_) {}

void Progress::show(double share) {
    share = std::clamp(share, 0.0, 1.0);
    terminal_ ? show_bar(share) : show_line(share);
}

void Progress::show_bar(double share) {
    const auto now = Clock::now();
    if (now - last_bar_ < bar_interval) return;
    last_bar_ = now;
    const double spent = std::chrono::duration<double>(now - start_).count();
    const int filled = int(share * bar_width);
    fmt::print(stderr, "\r\x1b[K[{:#<{}}{:.<{}}] {:3.0f} %", "", filled, "", bar_width - filled,
               100.0 * share);
    if (share > 0.0) fmt::print(stderr, ", {} left", format_seconds(spent * (1.0 - share) / share));
    std::fflush(stderr);
    bar_shown_ = true;
}

void Progress::show_line(double share) {
    const int tenths = int(share * 10.0 + 1e-9);
    if (tenths <= tenths_) return;
    tenths_ = tenths;
    const double spent = std::chrono::duration<double>(Clock::now() - start_).count();
    fmt::print(stderr, "{:3} %, {} left\n", 10 * tenths,
               format_seconds(spent * (1.0 - share) / share));
}

void Progress::finish(bool done) {
    if (done && !terminal_) show_line(1.0);
    if (bar_shown_) fmt::print(stderr, "\r\x1b[K");
    bar_shown_ = false;
}

}  // namespace meniscus::cli
