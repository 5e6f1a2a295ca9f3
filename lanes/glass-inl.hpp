// Fourth stage of a step: surfaces between clear media.

#if defined(MENISCUS_LANES_GLASS) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_GLASS
#undef MENISCUS_LANES_GLASS
#else
#define MENISCUS_LANES_GLASS
#endif

#include "lanes/chance-inl.hpp"
#include "lanes/chance.hpp"
#include "lanes/kernel-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

/// Two branches: which are followed, what share of the light and of the weight each has, and its
/// key.
struct Choice {
    M reflects, transmits;
    F reflect_share, transmit_share;
    U reflect_key, transmit_key;
};

/// `choose` of lanes/chance.hpp: both branches while the weight is high, then one by chance, which
/// has all of the light.
HWY_INLINE void choose(Choice& choice, F reflectance, F weight, U key) {
    const M one = choice.reflects & choice.transmits & (weight < F(split_above));
    if (!any(one)) return;
    const M mirror = chance(key, 3) < reflectance;
    choice.transmits = but_not(choice.transmits, one & mirror);
    choice.reflects = but_not(choice.reflects, but_not(one, mirror));
    choice.reflect_share = select(one, F(1.0), choice.reflect_share);
    choice.transmit_share = select(one, F(1.0), choice.transmit_share);
}

/// `survive` of lanes/chance.hpp: rays of very low weight go on by chance.
HWY_INLINE void survive(M& follows, F& share, F parent_weight, U key) {
    const F weight = parent_weight * share;
    const M faint = follows & (weight < F(roulette_below));
    if (!any(faint)) return;
    const F survival = max(weight / F(roulette_below), F(0.05));
    const M survives = chance(key, 4) < survival;
    follows = but_not(follows, but_not(faint, survives));
    share = select(faint & survives, share * (F(1.0) / survival), share);
}

/// Exact Fresnel reflection and refraction.
HWY_INLINE void Kernel::split(Batch& batch) {
    const M splits = batch.glass;
    const F3& direction = batch.rays.world.direction;
    const F n1 = batch.medium_before.ior, n2 = batch.medium_after.ior;
    const F facing = dot(batch.normal, direction);
    const F3 n = select(F(0.0) < facing, F(-1.0) * batch.normal, batch.normal);
    const F cosine = min(F(1.0), abs(facing));
    // n1 and n2 times the cosines on both sides; Snell's law says what is left for n2's.
    const F along = n1 * cosine;
    const F square = n2 * n2 - n1 * n1 * (F(1.0) - cosine * cosine);
    const M total = square <= F(0.0);
    const F beyond = sqrt(max(square, F(0.0)));
    // Both polarisations and the refracted direction over one denominator.
    const F across = n2 * n2 * cosine, back = n1 * beyond;
    const F s_down = along + beyond, p_down = across + back;
    const F inverse = F(1.0) / (s_down * p_down * n2);
    const F per_both = inverse * n2;
    const F s = (along - beyond) * p_down * per_both, p = (across - back) * s_down * per_both;
    const F per_n2 = inverse * (s_down * p_down);
    const F reflectance = select(total, F(1.0), F(0.5) * (s * s + p * p));
    const F transmittance = F(1.0) - reflectance;

    Choice choice;
    choice.reflects = splits & (F(0.0) < reflectance);
    choice.transmits = but_not(
        splits & (F(program_.whitted ? program_.least_weight : 0.0) < transmittance), total);
    choice.reflect_share = reflectance;
    choice.transmit_share = transmittance;
    if (program_.sampled) {
        choice.reflect_key = reflected_key(batch.key);
        choice.transmit_key = transmitted_key(batch.key);
        choose(choice, reflectance, batch.weight, batch.key);
        survive(choice.reflects, choice.reflect_share, batch.weight, choice.reflect_key);
        survive(choice.transmits, choice.transmit_share, batch.weight, choice.transmit_key);
    }
    counts_.reflected += count(choice.reflects);
    counts_.refracted += count(choice.transmits);

    const M may_go_on =
        batch.level < U(std::uint64_t(program_.most_levels) << RayCode::level_shift);
    const F floor(program_.least_weight);
    Child child;
    child.way = F(0.0);
    const U code = (batch.code & U(~(RayCode::level_mask | RayCode::straight))) | batch.level;

    child.weight = batch.weight * choice.reflect_share;
    const M reflects = choice.reflects & may_go_on & (floor <= child.weight);
    child.direction = unit(direction + F(2.0) * cosine * n);
    if (has_colour(false)) child.light = choice.reflect_share * batch.throughput;
    child.code = code | U(RayCode::reflected);
    if (has_key(false)) child.key = program_.sampled ? choice.reflect_key : batch.key;
    push(*batch.stack, batch, reflects, child, batch.before, false);

    child.weight = batch.weight * choice.transmit_share;
    const M transmits = choice.transmits & may_go_on & (floor <= child.weight);
    const M bends = F(1e-10) * n2 <= abs(n1 - n2);
    child.direction =
        select(bends, unit((n1 * per_n2) * direction + ((along - beyond) * per_n2) * n), direction);
    if (has_colour(false)) child.light = choice.transmit_share * batch.throughput;
    child.code = code | only(but_not(transmits, bends), U(RayCode::straight));
    if (has_key(false)) child.key = program_.sampled ? choice.transmit_key : batch.key;
    push_by_place(batch, transmits, child, batch.after);
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
