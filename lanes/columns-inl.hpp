// Numbers of all lanes in memory, and what is done one lane at a time.

#if defined(MENISCUS_LANES_COLUMNS) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_COLUMNS
#undef MENISCUS_LANES_COLUMNS
#else
#define MENISCUS_LANES_COLUMNS
#endif

#include "lanes/spans-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

/// Numbers of all lanes, for what is done one lane at a time.
template <class T>
struct Column {
    alignas(64) T at[lanes];
    Column() = default;
    HWY_INLINE Column(F x) { store(x, at); }
    HWY_INLINE Column(U x) { store(x, at); }
    T& operator[](std::size_t lane) { return at[lane]; }
    T operator[](std::size_t lane) const { return at[lane]; }
};
using Doubles = Column<double>;
using Words = Column<std::uint64_t>;

/// Calls visit(lane) for each lane of a mask.
template <class Visit>
HWY_INLINE void for_each(std::uint32_t lane_bits, Visit&& visit) {
    for (std::uint32_t left = lane_bits; left; left &= left - 1)
        visit(std::size_t(__builtin_ctz(left)));
}
template <class Visit>
HWY_INLINE void for_each(M mask, Visit&& visit) {
    for_each(bits(mask), visit);
}

/// All rays as numbers.
struct Line3 {
    Doubles ox, oy, oz, dx, dy, dz;
    HWY_INLINE explicit Line3(const Rays& rays)
        : ox(rays.world.origin.x),
          oy(rays.world.origin.y),
          oz(rays.world.origin.z),
          dx(rays.world.direction.x),
          dy(rays.world.direction.y),
          dz(rays.world.direction.z) {}
    geom::Ray ray(std::size_t lane) const {
        geom::Ray result;
        result.origin = {ox[lane], oy[lane], oz[lane]};
        result.direction = {dx[lane], dy[lane], dz[lane]};
        return result;
    }
};

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
