#include <cstddef>
#include <cstdint>
#include <string>

#include "lang/interpret.hpp"

/// Any bytes are a scene or a SourceError: nothing else may happen.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    meniscus::lang::Options options;
    options.allow_files = false;
    options.limits.loop_steps = 1000;
    options.limits.macro_depth = 50;
    options.limits.array_elements = 1000;
    options.limits.string_bytes = 10000;
    options.limits.objects = 1000;
    try {
        meniscus::lang::interpret_text(
            "fuzz.scene", std::string(reinterpret_cast<const char*>(data), size), options);
    } catch (const meniscus::lang::SourceError& error) {
        (void)meniscus::lang::format(error);
    }
    return 0;
}
