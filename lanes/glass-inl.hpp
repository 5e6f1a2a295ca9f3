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

/// What chance makes of two branches: which are followed, and how their light grows for it.
struct Choice {
    M reflects, transmits;
    F reflect_weight, transmit_weight;
    U reflect_key, transmit_key;
    F reflect_gain, transmit_gain;
};

/// `choose` of lanes/chance.hpp: both branches while the weight is high, then one by chance.
HWY_INLINE void choose(Choice& choice, M splits, F reflectance, F transmittance, F weight, U key) {
    const F sum = reflectance + transmittance;
    const M one =
        splits & choice.reflects & choice.transmits & (weight < F(split_above)) & (F(0.0) < sum);
    if (!any(one)) return;
    const F p = reflectance / sum;
    const M mirror = chance(key, 3) < p;
    choice.transmits = but_not(choice.transmits, one & mirror);
    choice.reflects = but_not(choice.reflects, but_not(one, mirror));
    choice.reflect_gain = select(one, F(1.0) / p, F(1.0));
    choice.transmit_gain = select(one, F(1.0) / (F(1.0) - p), F(1.0));
    choice.reflect_weight = choice.reflect_weight * choice.reflect_gain;
    choice.transmit_weight = choice.transmit_weight * choice.transmit_gain;
}

/// `survive` of lanes/chance.hpp: rays of very low weight go on by chance.
HWY_INLINE void survive(M& follows, F& weight, F& gain, U key) {
    const M faint = follows & (weight < F(roulette_below));
    if (!any(faint)) return;
    const F survival = max(weight / F(roulette_below), F(0.05));
    const M survives = chance(key, 4) < survival;
    follows = but_not(follows, but_not(faint, survives));
    const F more = select(faint & survives, F(1.0) / survival, F(1.0));
    weight = weight * more;
    gain = gain * more;
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
    choice.reflect_weight = batch.weight * reflectance;
    choice.transmit_weight = batch.weight * transmittance;
    choice.reflect_gain = choice.transmit_gain = F(1.0);
    if (program_.sampled) {
        choice.reflect_key = reflected_key(batch.key);
        choice.transmit_key = transmitted_key(batch.key);
        choose(choice, splits, reflectance, transmittance, batch.weight, batch.key);
        survive(choice.reflects, choice.reflect_weight, choice.reflect_gain, choice.reflect_key);
        survive(choice.transmits, choice.transmit_weight, choice.transmit_gain,
                choice.transmit_key);
    }
    counts_.reflected += count(choice.reflects);
    counts_.refracted += count(choice.transmits);

    const M may_go_on =
        batch.level < U(std::uint64_t(program_.most_levels) << RayCode::level_shift);
    const F floor(program_.least_weight);
    Child child;
    child.way = F(0.0);
    const U code = (batch.code & U(~(RayCode::level_mask | RayCode::straight))) | batch.level;

    const M reflects = choice.reflects & may_go_on & (floor <= choice.reflect_weight);
    child.direction = unit(direction + F(2.0) * cosine * n);
    if (has_colour(false)) child.light = (choice.reflect_gain * reflectance) * batch.throughput;
    child.weight = choice.reflect_weight;
    child.code = code | U(RayCode::reflected);
    if (has_key(false)) child.key = program_.sampled ? choice.reflect_key : batch.key;
    push(*batch.stack, batch, reflects, child, batch.before, false);

    const M transmits = choice.transmits & may_go_on & (floor <= choice.transmit_weight);
    const M bends = F(1e-10) * n2 <= abs(n1 - n2);
    child.direction =
        select(bends, unit((n1 * per_n2) * direction + ((along - beyond) * per_n2) * n), direction);
    if (has_colour(false)) child.light = (choice.transmit_gain * transmittance) * batch.throughput;
    child.weight = choice.transmit_weight;
    child.code = code | only(but_not(transmits, bends), U(RayCode::straight));
    if (has_key(false)) child.key = program_.sampled ? choice.transmit_key : batch.key;
    push_by_place(batch, transmits, child, batch.after);
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
