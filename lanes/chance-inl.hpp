// What chance decides, in lanes: the same functions of a ray's key as in lanes/chance.hpp.

#if defined(MENISCUS_LANES_CHANCE) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_CHANCE
#undef MENISCUS_LANES_CHANCE
#else
#define MENISCUS_LANES_CHANCE
#endif

#include "lanes/vector-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

HWY_INLINE U mix(U x) {
    x = x + U(0x9e3779b97f4a7c15ull);
    x = (x ^ shift_right(x, 30)) * U(0xbf58476d1ce4e5b9ull);
    x = (x ^ shift_right(x, 27)) * U(0x94d049bb133111ebull);
    return x ^ shift_right(x, 31);
}
HWY_INLINE U reflected_key(U key) { return mix(key + U(1)); }
HWY_INLINE U transmitted_key(U key) { return mix(key + U(2)); }
/// In [0, 1): 3 for branches, 4 for survival.
HWY_INLINE F chance(U key, std::uint64_t what) {
    const U bits = shift_right(mix(key + U(what)), 11);
    // 53 bits: the upper 26 and the lower 27 apart, since only 52 fit to_double.
    return F(0x1p-53) *
           (F(0x1p27) * to_double(shift_right(bits, 27)) + to_double(bits & U((1ull << 27) - 1)));
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
