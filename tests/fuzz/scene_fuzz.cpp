#include <cstddef>
#include <cstdint>
#include <string>

#include "lang/interpret.hpp"

/// Any bytes are either a scene or an error that names a place; nothing else may happen.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace meniscus;
    lang::Options options;
    options.allow_files = false;
    options.limits.loop_steps = 10'000;
    options.limits.array_elements = 10'000;
    options.limits.objects = 10'000;
    options.limits.string_bytes = 1 << 16;
    try {
        lang::interpret_text("fuzz", std::string(reinterpret_cast<const char*>(data), size),
                             options);
    } catch (const lang::SourceError& error) {
        if (lang::format(error).empty()) __builtin_trap();
    }
    return 0;
}
