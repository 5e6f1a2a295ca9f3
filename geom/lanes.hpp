#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace meniscus::geom {

/// Four numbers that are worked on at once, where the processor can.
#if defined(__SSE2__)
struct Lanes {
    __m128 v;

    static Lanes all(float x) { return {_mm_set1_ps(x)}; }
    static Lanes load(const float* x) { return {_mm_load_ps(x)}; }
    void store(float* x) const { _mm_store_ps(x, v); }

    friend Lanes operator+(Lanes a, Lanes b) { return {_mm_add_ps(a.v, b.v)}; }
    friend Lanes operator-(Lanes a, Lanes b) { return {_mm_sub_ps(a.v, b.v)}; }
    friend Lanes operator*(Lanes a, Lanes b) { return {_mm_mul_ps(a.v, b.v)}; }
    friend Lanes min(Lanes a, Lanes b) { return {_mm_min_ps(a.v, b.v)}; }
    friend Lanes max(Lanes a, Lanes b) { return {_mm_max_ps(a.v, b.v)}; }
    /// Bit i is set where a <= b in lane i.
    friend unsigned at_most(Lanes a, Lanes b) {
        return static_cast<unsigned>(_mm_movemask_ps(_mm_cmple_ps(a.v, b.v)));
    }
};
#else
struct Lanes {
    std::array<float, 4> v;

    static Lanes all(float x) { return {{x, x, x, x}}; }
    static Lanes load(const float* x) { return {{x[0], x[1], x[2], x[3]}}; }
    void store(float* x) const {
        for (int i = 0; i < 4; ++i) x[i] = v[i];
    }

    template <class Operation>
    static Lanes each(Lanes a, const Lanes& b, Operation operation) {
        for (int i = 0; i < 4; ++i) a.v[i] = operation(a.v[i], b.v[i]);
        return a;
    }
    friend Lanes operator+(Lanes a, Lanes b) {
        return each(a, b, [](float x, float y) { return x + y; });
    }
    friend Lanes operator-(Lanes a, Lanes b) {
        return each(a, b, [](float x, float y) { return x - y; });
    }
    friend Lanes operator*(Lanes a, Lanes b) {
        return each(a, b, [](float x, float y) { return x * y; });
    }
    friend Lanes min(Lanes a, Lanes b) {
        return each(a, b, [](float x, float y) { return x < y ? x : y; });
    }
    friend Lanes max(Lanes a, Lanes b) {
        return each(a, b, [](float x, float y) { return x > y ? x : y; });
    }
    friend unsigned at_most(Lanes a, Lanes b) {
        unsigned mask = 0;
        for (int i = 0; i < 4; ++i) mask |= unsigned{a.v[i] <= b.v[i]} << i;
        return mask;
    }
};
#endif

/// Asks memory for something that will be read soon.
template <class T>
inline void fetch_ahead(const T& what) {
    const char* const begin = reinterpret_cast<const char*>(&what);
    for (std::size_t i = 0; i < sizeof what; i += 64) __builtin_prefetch(begin + i);
}

}  // namespace meniscus::geom
