// All lanes in single precision, for what need not be exact.

#if defined(MENISCUS_LANES_SINGLES) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_SINGLES
#undef MENISCUS_LANES_SINGLES
#else
#define MENISCUS_LANES_SINGLES
#endif

#include "lanes/vector-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR
struct S {
    float a, b;
};
HWY_INLINE S singles(F x) { return {float(x.a.raw), float(x.b.raw)}; }
HWY_INLINE S singles(float x) { return {x, x}; }
HWY_INLINE S operator+(S x, S y) { return {x.a + y.a, x.b + y.b}; }
HWY_INLINE S operator-(S x, S y) { return {x.a - y.a, x.b - y.b}; }
HWY_INLINE S operator*(S x, S y) { return {x.a * y.a, x.b * y.b}; }
HWY_INLINE std::uint32_t operator<(S x, S y) {
    return std::uint32_t(x.a < y.a) | std::uint32_t(x.b < y.b) << 1;
}
HWY_INLINE void store(S x, float* to) {
    to[0] = x.a;
    to[1] = x.b;
}
#else
using SingleTag = hn::ScalableTag<float>;
struct S {
    hn::Vec<SingleTag> v;
};
HWY_INLINE S singles(F x) {
    const hn::Rebind<float, DoubleTag> half;
    return {hn::Combine(SingleTag{}, hn::DemoteTo(half, x.b), hn::DemoteTo(half, x.a))};
}
HWY_INLINE S singles(float x) { return {hn::Set(SingleTag{}, x)}; }
HWY_INLINE S operator+(S x, S y) { return {hn::Add(x.v, y.v)}; }
HWY_INLINE S operator-(S x, S y) { return {hn::Sub(x.v, y.v)}; }
HWY_INLINE S operator*(S x, S y) { return {hn::Mul(x.v, y.v)}; }
HWY_INLINE void store(S x, float* to) { hn::StoreU(x.v, SingleTag{}, to); }
/// A bit for each lane.
HWY_INLINE std::uint32_t operator<(S x, S y) {
    const auto less = hn::Lt(x.v, y.v);
#if HWY_TARGET == HWY_AVX3
    return less.raw;
#elif HWY_TARGET == HWY_AVX2
    return std::uint32_t(_mm256_movemask_ps(less.raw));
#else
    std::uint8_t stored[8] = {};
    hn::StoreMaskBits(SingleTag{}, less, stored);
    return stored[0] & ((1u << lanes) - 1u);
#endif
}
#endif

/// A bit for each of up to eight.
template <class Mask>
HWY_INLINE std::uint32_t bits_of_eight(Mask x) {
#if HWY_TARGET == HWY_AVX3
    return x.raw;
#elif HWY_TARGET == HWY_AVX2
    return std::uint32_t(_mm256_movemask_ps(x.raw));
#else
    const hn::CappedTag<float, 8> tag;
    std::uint8_t stored[8] = {};
    hn::StoreMaskBits(tag, x, stored);
    return stored[0];
#endif
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
