// One step of the kernel: the rays on top of a stack go to where their medium next changes, and
// what they split into is pushed. docs/kernels.md walks through it.

#if defined(MENISCUS_LANES_STEP) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_STEP
#undef MENISCUS_LANES_STEP
#else
#define MENISCUS_LANES_STEP
#endif

#include "lanes/approach-inl.hpp"
#include "lanes/arrive-inl.hpp"
#include "lanes/camera-inl.hpp"
#include "lanes/dress-inl.hpp"
#include "lanes/glass-inl.hpp"
#include "lanes/lists-inl.hpp"
#include "lanes/meet-inl.hpp"
#include "lanes/paint-inl.hpp"
#include "lanes/put_on_faces-inl.hpp"
#include "lanes/stacks-inl.hpp"
#include "lanes/whole_lists-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

Counts Kernel::run() {
    std::size_t bin = 0;
    while (true) {
        if (stacks_.shadows.size() >= lanes) {
            step(stacks_.shadows, program_.everything, true);
            continue;
        }
        if (stacks_.bins[bin].size() < lanes) bin = stacks_.fullest();
        if (stacks_.bins[bin].size() < lanes) {
            add_camera_rays();
            bin = stacks_.fullest();
        }
        if (stacks_.bins[bin].size() > 0) {
            step(stacks_.bins[bin], program_.bins[bin], false);
        } else if (stacks_.shadows.size() > 0) {
            step(stacks_.shadows, program_.everything, true);
        } else {
            return counts_;
        }
    }
}

void Kernel::step(RayStack& stack, const Surroundings& around, bool is_shadow) {
    Batch batch;
    batch.around = &around;
    take(batch, stack, is_shadow);
    if (Findings found; approach(batch, found), !list_event(batch, found)) {
        batch.around = &program_.everything;
        Findings whole;
        find_stretches(batch, whole);
        find_event(batch, whole);
    }
    if (program_.has_meshes) doubt_meshes(batch);
    mark_ties(batch);
    if (any(batch.unsure)) hand_over(batch, stack);
    count_event(batch);
    tell_surfaces(batch);
    if (program_.attenuates) attenuate(batch);
    const M gone = but_not(batch.rays.active, batch.met);
    if (any(gone)) arrive(batch, gone);
    if (!any(batch.met)) return;
    put_on_faces(batch);

    const M passes = is_shadow ? batch.nothing | batch.glass : batch.nothing;
    if (any(passes)) pass(batch, passes);
    if (!is_shadow && any(batch.glass)) split(batch);
    if (any(batch.painted)) paint(batch);
    if (any(batch.dressed)) dress(batch);
}

/// What is too close to call is followed by the host.
HWY_INLINE void Kernel::hand_over(Batch& batch, RayStack& stack) {
    for_each(batch.unsure, [&](std::size_t lane) {
        const WaitingRay ray = waiting(stack, batch.base + lane, batch.is_shadow);
        add_light(ray.code, host_.follow(ray));
        --counts_.segments;
        ++counts_.handed_over;
    });
    batch.rays.active = but_not(batch.rays.active, batch.unsure);
    batch.met = but_not(batch.met, batch.unsure);
}

HWY_INLINE void Kernel::count_event(Batch& batch) {
    const Rays& rays = batch.rays;
    counts_.segments += batch.size;
    counts_.true_crossings += count(batch.met);
    if (batch.has_passed) {
        const Doubles skipped(batch.false_crossings);
        for_each(rays.active & (F(0.0) < batch.false_crossings), [&](std::size_t lane) {
            counts_.false_crossings += std::uint64_t(skipped[lane]);
        });
    }
    batch.level = batch.code & U(RayCode::level_mask);
    if (batch.is_shadow) return;
    batch.level =
        batch.level + select(shares(batch.code, U(RayCode::straight)), U(0), U(RayCode::one_level));
    const U deepest(std::uint64_t(counts_.deepest_level) << RayCode::level_shift);
    if (const M deeper = rays.active & (deepest < batch.level); any(deeper)) {
        const Words levels(batch.level);
        for_each(deeper, [&](std::size_t lane) {
            counts_.deepest_level =
                std::max(counts_.deepest_level, int(levels[lane] >> RayCode::level_shift));
        });
    }
}

/// What is met: the surface of the stronger of the two solids, or one that is always met.
HWY_INLINE void Kernel::tell_surfaces(Batch& batch) {
    const Medium &before = batch.medium_before, &after = batch.medium_after;
    // A ray that is too close to call is met no more.
    batch.by_surface = batch.by_surface & batch.met;
    batch.same = batch.same & batch.met;
    const M member_met = but_not(batch.met, batch.by_surface);
    const M clear = program_.has_dressed ? but_not(member_met, batch.owner_dressed) : member_met;
    // Nothing is there: the same solid before and after, or like media under a clear skin.
    const M alike =
        program_.ior_tells_medium ? before.ior == after.ior : before.medium == after.medium;
    batch.nothing = batch.same | (clear & alike);
    batch.glass = but_not(clear, batch.nothing);
    batch.dressed = but_not(but_not(batch.met, batch.nothing), batch.glass);
    batch.painted = no_lanes();
    if (batch.around->surfaces && any(batch.by_surface)) {
        if (program_.all_painted) {
            batch.painted = batch.by_surface;
        } else {
            for (std::size_t i = program_.listed_solids; i < program_.solids.size(); ++i) {
                if (program_.solids[i].paint >= 0)
                    batch.painted =
                        batch.painted | (batch.by_surface & (batch.owner_index == U(i)));
            }
        }
        batch.dressed = but_not(batch.dressed, batch.painted);
    }
}

/// Straight on, where nothing is, and for light that goes to a lamp.
HWY_INLINE void Kernel::pass(Batch& batch, M which) {
    Child child;
    child.direction = batch.rays.world.direction;
    if (has_colour(batch.is_shadow)) child.light = batch.throughput;
    if (batch.is_shadow) {
        child.t_max = batch.rays.t_max - batch.t;
    } else {
        child.weight = batch.weight;
    }
    if (program_.attenuates) child.way = select(batch.nothing, batch.way_before + batch.t, F(0.0));
    if (has_key(batch.is_shadow)) child.key = batch.key;
    child.code = (batch.code & U(~RayCode::level_mask)) | batch.level;
    if (!batch.is_shadow) child.code = child.code | U(RayCode::straight);
    if (batch.is_shadow) {
        push(stacks_.shadows, batch, which, child, batch.after, true);
    } else {
        push_by_place(batch, which, child, batch.after);
    }
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
