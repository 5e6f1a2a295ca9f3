#include "bench/machine.hpp"

#include <fmt/format.h>

#include <fstream>
#include <string_view>
#include <thread>

namespace meniscus::bench {
namespace {

/// The first value of a key in /proc/cpuinfo; empty where there is none.
std::string cpu_info(std::string_view key) {
    std::ifstream file("/proc/cpuinfo");
    std::string line;
    while (std::getline(file, line)) {
        const auto colon = line.find(": ");
        if (line.starts_with(key) && colon != line.npos) return line.substr(colon + 2);
    }
    return {};
}

}  // namespace

std::string machine_name() {
    auto name = cpu_info("model name");
    if (name.empty()) name = "unknown processor";
    // Names may hide what a virtual machine runs on; these tell it.
    const auto family = cpu_info("cpu family"), model = cpu_info("model\t");
    if (!family.empty() && !model.empty())
        name += fmt::format(" (family {}, model {})", family, model);
    const auto flags = ' ' + cpu_info("flags") + ' ';
    const auto knows = [&](const char* flag) { return flags.find(flag) != flags.npos; };
    const char* vectors = knows(" avx512f ") ? ", AVX-512" : knows(" avx2 ") ? ", AVX2" : "";
    const unsigned cores = std::thread::hardware_concurrency();
    return fmt::format("{}, {} {}{}", name, cores, cores == 1 ? "core" : "cores", vectors);
}

}  // namespace meniscus::bench
