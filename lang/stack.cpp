#include "lang/stack.hpp"

#include <pthread.h>

#include <cstddef>
#include <exception>
#include <system_error>

namespace meniscus::lang {
namespace {

constexpr std::ptrdiff_t stack_bytes = 64 << 20;  // address space; only what is used takes memory
constexpr std::ptrdiff_t most_bytes = stack_bytes / 4 * 3;

thread_local const char* top = nullptr;

const char* here() { return static_cast<const char*>(__builtin_frame_address(0)); }

struct Job {
    const std::function<void()>& work;
    std::exception_ptr failure;
};

void* run(void* argument) {
    auto& job = *static_cast<Job*>(argument);
    top = here();
    try {
        job.work();
    } catch (...) {
        job.failure = std::current_exception();
    }
    return nullptr;
}

void require(int error) {
    if (error) throw std::system_error(error, std::generic_category(), "a stack to read scenes on");
}

}  // namespace

void run_on_own_stack(const std::function<void()>& work) {
    Job job{work, nullptr};
    pthread_attr_t attributes;
    require(pthread_attr_init(&attributes));
    pthread_attr_setstacksize(&attributes, stack_bytes);
    pthread_t thread{};
    const int error = pthread_create(&thread, &attributes, run, &job);
    pthread_attr_destroy(&attributes);
    require(error);
    pthread_join(thread, nullptr);
    if (job.failure) std::rethrow_exception(job.failure);
}

bool stack_is_nearly_full() {
    const auto used = top - here();
    return top && (used > most_bytes || used < -most_bytes);
}

}  // namespace meniscus::lang
