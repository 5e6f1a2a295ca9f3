#pragma once

#include <stdexcept>

namespace meniscus::cli {

enum class ExitCode {
    done = 0,
    our_fault = 1,
    wrong_input = 2,   // the scene or an option
    file_failed = 3,   // cannot be read or written
    check_failed = 4,  // a comparison, `--strict` or `check` found something
    interrupted = 130
};

/// An option is wrong; the message is one line for its author.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace meniscus::cli
