#pragma once

#include <functional>

namespace meniscus::lang {

/// Runs the work, and waits for it, on a stack of its own: recursion follows the nesting of the
/// scene's text, and how deep it may go must not hang on the machine's settings or on how the
/// program was built. What the work throws is thrown here.
/// Throws std::system_error where no such stack can be had.
void run_on_own_stack(const std::function<void()>& work);

/// Whether work on such a stack has gone down so far that it must stop: the text is not to be
/// trusted.
bool stack_is_nearly_full();

}  // namespace meniscus::lang
