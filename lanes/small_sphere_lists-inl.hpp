// What small spheres have to do with the lists about an event.

#if defined(MENISCUS_LANES_SMALL_SPHERE_LISTS) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_SMALL_SPHERE_LISTS
#undef MENISCUS_LANES_SMALL_SPHERE_LISTS
#else
#define MENISCUS_LANES_SMALL_SPHERE_LISTS
#endif

#include "lanes/kernel-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

/// Contacts where the nearest crossings, alone, are on small spheres.
HWY_INLINE void Kernel::touch_small_spheres(Batch& batch, M which) const {
    const U ranks = as_words(load(batch.sphere_ranks.at) + F(0x1p52 + 1.0));
    batch.sphere_contacts_after = only(which, ranks & U(0xffffffffu));
    batch.contacts = select(which, U(0), batch.contacts);
}

/// The small spheres at `sphere_ranks` are the owners where `which`.
HWY_INLINE void Kernel::own_by_small_spheres(Batch& batch, std::uint32_t which, Medium& owner,
                                             List& bit) const {
    if (which == 0) return;
    Words own[list_words];
    for (int w = 0; w < program_.words; ++w) own[w] = Words(bit.word[w]);
    for_each(which, [&](std::size_t lane) {
        const auto rank = std::size_t(batch.sphere_ranks[lane]);
        for (int w = 0; w < program_.words; ++w) own[w][lane] = 0;
        own[rank / 64][lane] = 1ull << (rank % 64);
    });
    for (int w = 0; w < program_.words; ++w) bit.word[w] = load(own[w].at);
    owner.become(which, batch.sphere_ranks, program_);
}

/// Of the solid whose crossing is nearest.
HWY_INLINE F Kernel::nearest_magnitude(const Batch& batch, U index) const {
    Doubles magnitude(look_up(table_.magnitude, index));
    for_each(batch.near_spheres & bits(index == U(is_small_sphere)), [&](std::size_t lane) {
        magnitude[lane] = magnitudes_[std::size_t(batch.sphere_ranks[lane])];
    });
    return load(magnitude.at);
}

/// The lanes with a small sphere on top of a list, and its rank.
HWY_INLINE std::uint32_t Kernel::covered_by_small_spheres(const List& list, Doubles& ranks) const {
    M some = no_lanes();
    for (int w = 0; w < program_.words; ++w) some = some | shares(list.word[w], U(group_bits_[w]));
    if (!any(some)) return 0;
    const ListWords words(list, program_);
    std::uint32_t covered = 0;
    for_each(some, [&](std::size_t lane) {
        const int rank = words.top(lane);
        if (!(group_bits_[rank / 64] >> (rank % 64) & 1u)) return;
        ranks[lane] = rank;
        covered |= 1u << lane;
    });
    return covered;
}

/// The lists of small spheres about an event, lane by lane, from their stretches: none of them
/// stands in `before` and `after` yet.
HWY_INLINE void Kernel::list_small_spheres(Batch& batch, F pivot, F reach, M& torn) {
    batch.sphere_contacts_after = U(0);
    if (batch.near_spheres == 0) return;
    batch.has_passed = true;
    const Doubles at(batch.t), margin(reach), largest(batch.rays.largest), pivots(pivot);
    std::uint32_t doubtful = 0;
    Doubles skipped(batch.false_crossings);
    Words list_before[list_words], list_after[list_words], contacts_after(U(0));
    for (int w = 0; w < program_.words; ++w) {
        list_before[w] = Words(batch.before.word[w]);
        list_after[w] = Words(batch.after.word[w]);
    }
    for_each(batch.near_spheres, [&](std::size_t lane) {
        const SphereStretches& list = batch.spheres[lane];
        int contacts = 0;
        for (int k = 0; k < list.size; ++k) {
            const SphereStretch& stretch = list.at[k];
            const double tolerance =
                std::max(program_.tolerance_units * unit_roundoff *
                             (largest[lane] + at[lane] +
                              std::max(pivots[lane], magnitudes_[std::size_t(stretch.rank)])),
                         program_.contact_tolerance);
            const double low = at[lane] - tolerance, high = at[lane] + tolerance;
            const bool entered = stretch.in < low, entered_after = stretch.in <= high;
            const bool left = stretch.out < low, left_after = stretch.out <= high;
            const bool enters = entered != entered_after, leaves = left != left_after;
            if (enters != (std::abs(stretch.in - at[lane]) <= margin[lane]) ||
                leaves != (std::abs(stretch.out - at[lane]) <= margin[lane]))
                doubtful |= 1u << lane;
            const std::size_t word = std::size_t(stretch.rank / 64);
            const std::uint64_t bit = 1ull << (stretch.rank % 64);
            if (entered && !left) list_before[word][lane] |= bit;
            if (entered_after && !left_after) list_after[word][lane] |= bit;
            if (enters != leaves) {
                if (contacts == 2) {
                    doubtful |= 1u << lane;
                } else {
                    contacts_after[lane] |= std::uint64_t(stretch.rank + 1) << (32 * contacts++);
                }
            }
            skipped[lane] += (entered && stretch.in > -infinity) + left;
        }
    });
    if (doubtful != 0) torn = torn | mask_of(doubtful);
    batch.sphere_contacts_after = load(contacts_after.at);
    batch.false_crossings = load(skipped.at);
    for (int w = 0; w < program_.words; ++w) {
        batch.before.word[w] = load(list_before[w].at);
        batch.after.word[w] = load(list_after[w].at);
    }
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
