#include "lang/stack.hpp"

#include <cstddef>

namespace meniscus::lang {
namespace {

constexpr std::ptrdiff_t most_bytes = 5 << 20;  // of the usual 8 MiB

thread_local const char* mark = nullptr;

const char* here() { return static_cast<const char*>(__builtin_frame_address(0)); }

}  // namespace

StackMark::StackMark() : outer_(mark) {
    if (!mark) mark = here();
}
StackMark::~StackMark() { mark = outer_; }

bool stack_is_nearly_full() {
    const auto used = mark - here();
    return mark && (used > most_bytes || used < -most_bytes);
}

}  // namespace meniscus::lang
