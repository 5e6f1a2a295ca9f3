// Two vectors side by side, as wide as the instruction set has them: one step of the kernel works
// on both, so that the latency of one hides behind the other. Included once for each instruction
// set.

#if defined(MENISCUS_LANES_VECTOR) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_VECTOR
#undef MENISCUS_LANES_VECTOR
#else
#define MENISCUS_LANES_VECTOR
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using DoubleTag = hn::ScalableTag<double>;
using WordTag = hn::ScalableTag<std::uint64_t>;
inline constexpr DoubleTag doubles{};
inline constexpr WordTag integers{};
inline constexpr std::size_t width = hn::MaxLanes(DoubleTag{});
inline constexpr std::size_t lanes = 2 * width;

/// Doubles.
struct F {
    hn::Vec<DoubleTag> a, b;
    F() = default;
    HWY_INLINE F(hn::Vec<DoubleTag> first, hn::Vec<DoubleTag> second) : a(first), b(second) {}
    HWY_INLINE F(double x) : a(hn::Set(doubles, x)), b(a) {}  // NOLINT: a number is a vector of it
};
/// 64-bit words.
struct U {
    hn::Vec<WordTag> a, b;
    U() = default;
    HWY_INLINE U(hn::Vec<WordTag> first, hn::Vec<WordTag> second) : a(first), b(second) {}
    HWY_INLINE U(std::uint64_t x) : a(hn::Set(integers, x)), b(a) {}  // NOLINT
};
/// True or false.
struct M {
    hn::Mask<DoubleTag> a, b;
};

HWY_INLINE F operator+(F x, F y) { return {hn::Add(x.a, y.a), hn::Add(x.b, y.b)}; }
HWY_INLINE F operator-(F x, F y) { return {hn::Sub(x.a, y.a), hn::Sub(x.b, y.b)}; }
HWY_INLINE F operator*(F x, F y) { return {hn::Mul(x.a, y.a), hn::Mul(x.b, y.b)}; }
HWY_INLINE F operator/(F x, F y) { return {hn::Div(x.a, y.a), hn::Div(x.b, y.b)}; }
HWY_INLINE F operator-(F x) { return {hn::Neg(x.a), hn::Neg(x.b)}; }
HWY_INLINE F min(F x, F y) { return {hn::Min(x.a, y.a), hn::Min(x.b, y.b)}; }
HWY_INLINE F max(F x, F y) { return {hn::Max(x.a, y.a), hn::Max(x.b, y.b)}; }
HWY_INLINE F abs(F x) { return {hn::Abs(x.a), hn::Abs(x.b)}; }
HWY_INLINE F sqrt(F x) { return {hn::Sqrt(x.a), hn::Sqrt(x.b)}; }
HWY_INLINE F floor(F x) { return {hn::Floor(x.a), hn::Floor(x.b)}; }
HWY_INLINE M operator<(F x, F y) { return {hn::Lt(x.a, y.a), hn::Lt(x.b, y.b)}; }
HWY_INLINE M operator<=(F x, F y) { return {hn::Le(x.a, y.a), hn::Le(x.b, y.b)}; }
HWY_INLINE M operator>(F x, F y) { return y < x; }
HWY_INLINE M operator>=(F x, F y) { return y <= x; }
HWY_INLINE M operator==(F x, F y) { return {hn::Eq(x.a, y.a), hn::Eq(x.b, y.b)}; }

HWY_INLINE U operator+(U x, U y) { return {hn::Add(x.a, y.a), hn::Add(x.b, y.b)}; }
HWY_INLINE U operator&(U x, U y) { return {hn::And(x.a, y.a), hn::And(x.b, y.b)}; }
HWY_INLINE U operator^(U x, U y) { return {hn::Xor(x.a, y.a), hn::Xor(x.b, y.b)}; }
HWY_INLINE U operator|(U x, U y) { return {hn::Or(x.a, y.a), hn::Or(x.b, y.b)}; }
/// x without the bits of y.
HWY_INLINE U but_not(U x, U y) { return {hn::AndNot(y.a, x.a), hn::AndNot(y.b, x.b)}; }
HWY_INLINE U shift_right(U x, int by) {
    return {hn::ShiftRightSame(x.a, by), hn::ShiftRightSame(x.b, by)};
}
HWY_INLINE U shift_left(U x, int by) {
    return {hn::ShiftLeftSame(x.a, by), hn::ShiftLeftSame(x.b, by)};
}
HWY_INLINE U shift_left(U x, U by) { return {hn::Shl(x.a, by.a), hn::Shl(x.b, by.b)}; }
HWY_INLINE M operator==(U x, U y) {
    return {hn::RebindMask(doubles, hn::Eq(x.a, y.a)), hn::RebindMask(doubles, hn::Eq(x.b, y.b))};
}

/// Whether x has any of the bits of y.
HWY_INLINE M shares(U x, U y) {
#if HWY_TARGET == HWY_AVX3
    return {{_mm512_test_epi64_mask(x.a.raw, y.a.raw)}, {_mm512_test_epi64_mask(x.b.raw, y.b.raw)}};
#else
    const M none = (x & y) == U(0);
    return {hn::Not(none.a), hn::Not(none.b)};
#endif
}
/// Of words below 2^63.
HWY_INLINE M operator<(U x, U y) {
    const hn::Rebind<std::int64_t, DoubleTag> signed_tag;
    const auto less = [&](hn::Vec<WordTag> u, hn::Vec<WordTag> v) HWY_ATTR {
        return hn::RebindMask(doubles,
                              hn::Lt(hn::BitCast(signed_tag, u), hn::BitCast(signed_tag, v)));
    };
    return {less(x.a, y.a), less(x.b, y.b)};
}

HWY_INLINE M operator&(M x, M y) { return {hn::And(x.a, y.a), hn::And(x.b, y.b)}; }
HWY_INLINE M operator|(M x, M y) { return {hn::Or(x.a, y.a), hn::Or(x.b, y.b)}; }
HWY_INLINE M operator^(M x, M y) { return {hn::Xor(x.a, y.a), hn::Xor(x.b, y.b)}; }
HWY_INLINE M operator!(M x) { return {hn::Not(x.a), hn::Not(x.b)}; }
/// x and not y.
HWY_INLINE M but_not(M x, M y) { return {hn::AndNot(y.a, x.a), hn::AndNot(y.b, x.b)}; }
HWY_INLINE M select_mask(M m, M x, M y) { return (m & x) | but_not(y, m); }
HWY_INLINE M no_lanes() { return {hn::FirstN(doubles, 0), hn::FirstN(doubles, 0)}; }
/// The lower `n` lanes.
HWY_INLINE M first_lanes(std::size_t n) {
    return {hn::FirstN(doubles, n), hn::FirstN(doubles, n > width ? n - width : 0)};
}
/// A bit for each lane.
#if HWY_TARGET == HWY_AVX3
HWY_INLINE std::uint32_t bits(hn::Mask<DoubleTag> x) { return std::uint32_t(x.raw); }
HWY_INLINE bool any(M x) { return (x.a.raw | x.b.raw) != 0; }
#elif HWY_TARGET == HWY_AVX2
HWY_INLINE std::uint32_t bits(hn::Mask<DoubleTag> x) {
    return std::uint32_t(_mm256_movemask_pd(x.raw));
}
HWY_INLINE bool any(M x) { return _mm256_movemask_pd(_mm256_or_pd(x.a.raw, x.b.raw)) != 0; }
#else
HWY_INLINE std::uint32_t bits(hn::Mask<DoubleTag> x) {
    std::uint8_t stored[8] = {};
    hn::StoreMaskBits(doubles, x, stored);
    return stored[0] & ((1u << width) - 1u);
}
HWY_INLINE bool any(M x) { return (bits(x.a) | bits(x.b)) != 0; }
#endif
HWY_INLINE std::uint32_t bits(M x) { return bits(x.a) | bits(x.b) << width; }
HWY_INLINE std::size_t count(M x) { return std::size_t(__builtin_popcount(bits(x))); }

/// The lanes whose bits are set.
HWY_INLINE M mask_of(std::uint32_t lane_bits) {
    const std::uint8_t first[8] = {std::uint8_t(lane_bits & ((1u << width) - 1u))};
    const std::uint8_t second[8] = {std::uint8_t(lane_bits >> width)};
    return {hn::LoadMaskBits(doubles, first), hn::LoadMaskBits(doubles, second)};
}

HWY_INLINE F select(M m, F x, F y) {
    return {hn::IfThenElse(m.a, x.a, y.a), hn::IfThenElse(m.b, x.b, y.b)};
}
HWY_INLINE F only(M m, F x) { return {hn::IfThenElseZero(m.a, x.a), hn::IfThenElseZero(m.b, x.b)}; }
HWY_INLINE F but_not(M m, F x) {
    return {hn::IfThenZeroElse(m.a, x.a), hn::IfThenZeroElse(m.b, x.b)};
}
HWY_INLINE U select(M m, U x, U y) {
    return {hn::IfThenElse(hn::RebindMask(integers, m.a), x.a, y.a),
            hn::IfThenElse(hn::RebindMask(integers, m.b), x.b, y.b)};
}
HWY_INLINE U only(M m, U x) {
    return {hn::IfThenElseZero(hn::RebindMask(integers, m.a), x.a),
            hn::IfThenElseZero(hn::RebindMask(integers, m.b), x.b)};
}

HWY_INLINE F load(const double* from) {
    return {hn::LoadU(doubles, from), hn::LoadU(doubles, from + width)};
}
HWY_INLINE U load(const std::uint64_t* from) {
    return {hn::LoadU(integers, from), hn::LoadU(integers, from + width)};
}
HWY_INLINE void store(F x, double* to) {
    hn::StoreU(x.a, doubles, to);
    hn::StoreU(x.b, doubles, to + width);
}
HWY_INLINE void store(U x, std::uint64_t* to) {
    hn::StoreU(x.a, integers, to);
    hn::StoreU(x.b, integers, to + width);
}
/// The same bits.
HWY_INLINE U as_words(F x) { return {hn::BitCast(integers, x.a), hn::BitCast(integers, x.b)}; }
HWY_INLINE F as_doubles(U x) { return {hn::BitCast(doubles, x.a), hn::BitCast(doubles, x.b)}; }
/// Whole numbers below 2^52 as doubles.
HWY_INLINE F to_double(U x) { return as_doubles(x | U(0x4330000000000000ull)) - F(0x1p52); }
/// table[index] for a table of 16.
HWY_INLINE F look_up(const double* table, U index) {
#if HWY_TARGET == HWY_AVX3
    const __m512d low = _mm512_load_pd(table), high = _mm512_load_pd(table + 8);
    return {hn::Vec<DoubleTag>{_mm512_permutex2var_pd(low, index.a.raw, high)},
            hn::Vec<DoubleTag>{_mm512_permutex2var_pd(low, index.b.raw, high)}};
#else
    const hn::Rebind<std::int64_t, DoubleTag> signed_tag;
    return {hn::GatherIndex(doubles, table, hn::BitCast(signed_tag, index.a)),
            hn::GatherIndex(doubles, table, hn::BitCast(signed_tag, index.b))};
#endif
}
/// The nearest whole number of each, as two's complement; |x| < 2^51.
HWY_INLINE U round_to_word(F x) {
    return as_words(x + F(0x1.8p52)) + U(0ull - 0x4338000000000000ull);
}
/// Products modulo 2^64.
HWY_INLINE hn::Vec<WordTag> multiply(hn::Vec<WordTag> x, hn::Vec<WordTag> y) {
#if HWY_TARGET == HWY_AVX3
    return hn::Vec<WordTag>{_mm512_mullo_epi64(x.raw, y.raw)};
#elif HWY_TARGET == HWY_AVX2
    const __m256i low = _mm256_mul_epu32(x.raw, y.raw);
    const __m256i cross = _mm256_add_epi64(_mm256_mul_epu32(_mm256_srli_epi64(x.raw, 32), y.raw),
                                           _mm256_mul_epu32(x.raw, _mm256_srli_epi64(y.raw, 32)));
    return hn::Vec<WordTag>{_mm256_add_epi64(low, _mm256_slli_epi64(cross, 32))};
#else
    HWY_ALIGN std::uint64_t u[width], v[width];
    hn::Store(x, integers, u);
    hn::Store(y, integers, v);
    for (std::size_t i = 0; i < width; ++i) u[i] *= v[i];
    return hn::Load(integers, u);
#endif
}
HWY_INLINE U operator*(U x, U y) { return {multiply(x.a, y.a), multiply(x.b, y.b)}; }

/// Vectors of three.
struct F3 {
    F x, y, z;
    F3() = default;
    HWY_INLINE F3(F first, F second, F third) : x(first), y(second), z(third) {}
    HWY_INLINE F3(const geom::Vec3& v) : x(v.x), y(v.y), z(v.z) {}  // NOLINT
};
HWY_INLINE F3 operator+(F3 u, F3 v) { return {u.x + v.x, u.y + v.y, u.z + v.z}; }
HWY_INLINE F3 operator-(F3 u, F3 v) { return {u.x - v.x, u.y - v.y, u.z - v.z}; }
HWY_INLINE F3 operator*(F s, F3 v) { return {s * v.x, s * v.y, s * v.z}; }
HWY_INLINE F dot(F3 u, F3 v) { return u.x * v.x + u.y * v.y + u.z * v.z; }
HWY_INLINE F3 select(M m, F3 u, F3 v) {
    return {select(m, u.x, v.x), select(m, u.y, v.y), select(m, u.z, v.z)};
}
/// m * v, with `m` in columns.
HWY_INLINE F3 transform(const geom::Mat3& m, F3 v) {
    return {F(m[0].x) * v.x + F(m[1].x) * v.y + F(m[2].x) * v.z,
            F(m[0].y) * v.x + F(m[1].y) * v.y + F(m[2].y) * v.z,
            F(m[0].z) * v.x + F(m[1].z) * v.y + F(m[2].z) * v.z};
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
