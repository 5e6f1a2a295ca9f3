// How some lanes are stored one behind the other.

#if defined(MENISCUS_LANES_PACKING) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_PACKING
#undef MENISCUS_LANES_PACKING
#else
#define MENISCUS_LANES_PACKING
#endif

#include "lanes/vector-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

/// Which lanes to store one behind the other; the same for all fields of a ray.
class Packing {
public:
    HWY_INLINE explicit Packing(std::uint32_t lane_bits)
        : first_(lane_bits & ((1u << width) - 1u)),
          second_(lane_bits >> width),
          first_count_(std::size_t(__builtin_popcount(lane_bits & ((1u << width) - 1u)))),
          count_(std::size_t(__builtin_popcount(lane_bits))) {}

    std::size_t first_count() const { return first_count_; }
    std::size_t count() const { return count_; }
    /// The lanes that are chosen, moved to the lower end.
    HWY_INLINE F operator()(F x) const { return {first_(x.a), second_(x.b)}; }
    HWY_INLINE U operator()(U x) const { return {first_(x.a), second_(x.b)}; }

private:
#if HWY_TARGET == HWY_AVX3
    // A permutation for all fields: to compress each of them takes several times as long.
    struct Half {
        __m512i order;
        HWY_INLINE explicit Half(std::uint32_t m)
            : order(_mm512_maskz_compress_epi64(__mmask8(m),
                                                _mm512_set_epi64(7, 6, 5, 4, 3, 2, 1, 0))) {}
        HWY_INLINE hn::Vec<DoubleTag> operator()(hn::Vec<DoubleTag> x) const {
            return hn::Vec<DoubleTag>{_mm512_permutexvar_pd(order, x.raw)};
        }
        HWY_INLINE hn::Vec<WordTag> operator()(hn::Vec<WordTag> x) const {
            return hn::Vec<WordTag>{_mm512_permutexvar_epi64(order, x.raw)};
        }
    };
#elif HWY_TARGET == HWY_AVX2
    // By a table of permutations: Highway 1.0.3's own is copied to the stack at each call by g++
    // 12.
    alignas(32) static constexpr std::uint32_t table[16][8] = {
        {0, 1, 2, 3, 4, 5, 6, 7}, {0, 1, 2, 3, 4, 5, 6, 7}, {2, 3, 0, 1, 4, 5, 6, 7},
        {0, 1, 2, 3, 4, 5, 6, 7}, {4, 5, 0, 1, 2, 3, 6, 7}, {0, 1, 4, 5, 2, 3, 6, 7},
        {2, 3, 4, 5, 0, 1, 6, 7}, {0, 1, 2, 3, 4, 5, 6, 7}, {6, 7, 0, 1, 2, 3, 4, 5},
        {0, 1, 6, 7, 2, 3, 4, 5}, {2, 3, 6, 7, 0, 1, 4, 5}, {0, 1, 2, 3, 6, 7, 4, 5},
        {4, 5, 6, 7, 0, 1, 2, 3}, {0, 1, 4, 5, 6, 7, 2, 3}, {2, 3, 4, 5, 6, 7, 0, 1},
        {0, 1, 2, 3, 4, 5, 6, 7}};
    struct Half {
        __m256i order;
        HWY_INLINE explicit Half(std::uint32_t m)
            : order(_mm256_load_si256(reinterpret_cast<const __m256i*>(table[m]))) {}
        HWY_INLINE hn::Vec<DoubleTag> operator()(hn::Vec<DoubleTag> x) const {
            return hn::Vec<DoubleTag>{_mm256_castsi256_pd(
                _mm256_permutevar8x32_epi32(_mm256_castpd_si256(x.raw), order))};
        }
        HWY_INLINE hn::Vec<WordTag> operator()(hn::Vec<WordTag> x) const {
            return hn::Vec<WordTag>{_mm256_permutevar8x32_epi32(x.raw, order)};
        }
    };
#else
    struct Half {
        std::uint32_t lanes;
        HWY_INLINE explicit Half(std::uint32_t m) : lanes(m) {}
        template <class V>
        HWY_INLINE V operator()(V x) const {
            using Lane = hn::TFromV<V>;
            const hn::DFromV<V> tag;
            HWY_ALIGN Lane from[width], to[width] = {};
            hn::Store(x, tag, from);
            for (std::size_t i = 0, n = 0; i < width; ++i) {
                if (lanes >> i & 1u) to[n++] = from[i];
            }
            return hn::Load(tag, to);
        }
    };
#endif

    Half first_, second_;
    std::size_t first_count_, count_;
};
/// Stores packed lanes; up to `lanes` places are overwritten.
HWY_INLINE void store(F x, const Packing& packing, double* to) {
    const F packed = packing(x);
    hn::StoreU(packed.a, doubles, to);
    hn::StoreU(packed.b, doubles, to + packing.first_count());
}
HWY_INLINE void store(U x, const Packing& packing, std::uint64_t* to) {
    const U packed = packing(x);
    hn::StoreU(packed.a, integers, to);
    hn::StoreU(packed.b, integers, to + packing.first_count());
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
