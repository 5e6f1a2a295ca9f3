#pragma once

namespace meniscus::lang {

/// Remembers where the stack stood when the work began, and whether the work has gone down so far
/// that it must stop: recursion follows the nesting of the scene's text, and the text is not to be
/// trusted.
class StackMark {
public:
    StackMark();
    ~StackMark();
    StackMark(const StackMark&) = delete;
    StackMark& operator=(const StackMark&) = delete;

private:
    const char* outer_;
};

bool stack_is_nearly_full();

}  // namespace meniscus::lang
