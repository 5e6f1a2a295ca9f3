#include "lanes/kernel.hpp"

// Of the instruction sets that Highway knows, those worth their code: AVX-512, AVX2, and plain
// doubles for everything else.
#ifdef MENISCUS_PLAIN_LANES
#define HWY_COMPILE_ONLY_SCALAR
#endif
#include <hwy/detect_targets.h>
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lanes/kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "lanes/step-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

Counts run_all(const Program& program, Host& host, Stacks& stacks, std::int64_t* sums) {
    return Kernel(program, host, stacks, sums).run();
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace meniscus::lanes {
namespace {

HWY_EXPORT(run_all);

struct InstructionSet {
    const char* name;
    std::int64_t target;  // 0: plain
};
constexpr InstructionSet known_sets[] = {{"avx512", HWY_AVX3}, {"avx2", HWY_AVX2}, {"plain", 0}};

bool is_usable(const InstructionSet& set) {
    static const std::int64_t supported = hwy::SupportedTargets();
    return set.target == 0 || (supported & set.target & HWY_TARGETS) != 0;
}

}  // namespace

std::vector<std::string> instruction_sets() {
    std::vector<std::string> names;
    for (const InstructionSet& set : known_sets) {
        if (is_usable(set)) names.emplace_back(set.name);
    }
    return names;
}

WaitingRay Surface::next(const geom::Vec3& direction, bool behind) const {
    WaitingRay result;
    result.origin = point;
    result.direction = direction;
    result.throughput = ray.throughput;
    result.weight = ray.weight;
    result.birth_magnitude = magnitude;
    result.code = (ray.code & ~(RayCode::level_mask | RayCode::straight)) |
                  (std::uint64_t(level) << RayCode::level_shift);
    result.key = ray.key;
    result.inside = behind ? after : before;
    result.contacts = contacts;
    result.sphere_contacts = sphere_contacts;
    result.mesh_contacts = mesh_contacts;
    return result;
}

Counts run(const Program& program, Host& host, Stacks& stacks, std::int64_t* sums,
           const std::string& instruction_set) {
    for (const InstructionSet& set : known_sets) {
        if (!is_usable(set) || (!instruction_set.empty() && instruction_set != set.name)) continue;
#if (HWY_TARGETS & (HWY_TARGETS - 1)) == 0
        return HWY_STATIC_DISPATCH(run_all)(program, host, stacks, sums);
#else
        hwy::ChosenTarget chosen;
        chosen.Update(set.target);
        return HWY_DISPATCH_TABLE(run_all)[chosen.GetIndex()](program, host, stacks, sums);
#endif
    }
    throw std::invalid_argument("this machine has no instruction set \"" + instruction_set + "\"");
}

}  // namespace meniscus::lanes
#endif
