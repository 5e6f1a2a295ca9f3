// How rays go to and from the stacks: of a ray's fields only those that the program needs.

#if defined(MENISCUS_LANES_STACKS) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_STACKS
#undef MENISCUS_LANES_STACKS
#else
#define MENISCUS_LANES_STACKS
#endif

#include "lanes/kernel-inl.hpp"
#include "lanes/packing-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

/// Takes the rays on top of a stack.
HWY_INLINE void Kernel::take(Batch& batch, RayStack& stack, bool is_shadow) {
    using Stack = RayStack;
    batch.is_shadow = is_shadow;
    batch.stack = &stack;
    batch.size = std::min(stack.size(), lanes);
    batch.base = stack.size() - batch.size;
    stack.resize(batch.base);
    const auto numbers = [&](Stack::Field field) { return load(stack[field] + batch.base); };
    const auto words = [&](Stack::Field field) { return load(stack.word(field) + batch.base); };

    Rays& rays = batch.rays;
    rays.active = first_lanes(batch.size);
    rays.world.origin = {numbers(Stack::ox), numbers(Stack::oy), numbers(Stack::oz)};
    rays.world.direction = {numbers(Stack::dx), numbers(Stack::dy), numbers(Stack::dz)};
    if (is_shadow) rays.t_max = numbers(Stack::t_max);
    rays.largest =
        max(max(abs(rays.world.origin.x), abs(rays.world.origin.y)), abs(rays.world.origin.z));
    batch.code = words(Stack::code);
    rays.birth = max(as_doubles(batch.code & U(RayCode::birth_mask)), rays.largest);
    batch.code = batch.code & U(~RayCode::birth_mask);
    rays.contacts = words(Stack::contacts);
    // What nobody asks for is not even set.
    if (!is_shadow) batch.weight = numbers(Stack::weight);
    if (has_colour(is_shadow))
        batch.throughput = {numbers(Stack::red), numbers(Stack::green), numbers(Stack::blue)};
    if (program_.attenuates) batch.way_before = numbers(Stack::way);
    if (has_key(is_shadow)) batch.key = words(Stack::key);
    for (int w = 0; w < program_.words; ++w)
        batch.inside.word[w] = words(Stack::Field(Stack::inside + w));
    if (!program_.groups.empty()) batch.sphere_contacts = words(Stack::sphere_contacts);
    if (program_.has_meshes) {
        batch.mesh_contacts = words(Stack::mesh_contacts);
        batch.mesh_doubt = no_lanes();
        batch.mesh_known = F(infinity);
    }
    batch.is_mirrored = is_shadow ? no_lanes() : shares(batch.code, U(RayCode::reflected));
}

/// Rays that go on from the event.
HWY_INLINE void Kernel::push(RayStack& stack, const Batch& batch, M which, const Child& child,
                             const List& list, bool is_shadow) {
    using Stack = RayStack;
    const Packing packing(bits(which));
    if (packing.count() == 0) return;
    stack.reserve(stack.size() + lanes);
    const std::size_t at = stack.size();
    const auto numbers = [&](Stack::Field field, F x)
                             HWY_ATTR { store(x, packing, stack[field] + at); };
    const auto words = [&](Stack::Field field, U x)
                           HWY_ATTR { store(x, packing, stack.word(field) + at); };
    numbers(Stack::ox, batch.point.x);
    numbers(Stack::oy, batch.point.y);
    numbers(Stack::oz, batch.point.z);
    numbers(Stack::dx, child.direction.x);
    numbers(Stack::dy, child.direction.y);
    numbers(Stack::dz, child.direction.z);
    const U birth = (as_words(batch.magnitude) + U(RayCode::one_birth)) & U(RayCode::birth_mask);
    words(Stack::code, child.code | birth);
    words(Stack::contacts, batch.contacts);
    for (int w = 0; w < program_.words; ++w) words(Stack::Field(Stack::inside + w), list.word[w]);
    if (is_shadow) {
        numbers(Stack::t_max, child.t_max);
    } else {
        numbers(Stack::weight, child.weight);
    }
    if (has_colour(is_shadow)) {
        numbers(Stack::red, child.light.x);
        numbers(Stack::green, child.light.y);
        numbers(Stack::blue, child.light.z);
    }
    if (program_.attenuates) numbers(Stack::way, child.way);
    if (has_key(is_shadow)) words(Stack::key, child.key);
    if (!program_.groups.empty()) words(Stack::sphere_contacts, batch.sphere_contacts_after);
    if (program_.has_meshes) words(Stack::mesh_contacts, batch.mesh_contacts_after);
    stack.resize(at + packing.count());
}

/// The same for rays that see, to the bins of what they are in.
HWY_INLINE void Kernel::push_by_place(const Batch& batch, M which, const Child& child,
                                      const List& list) {
    const std::size_t last = stacks_.bins.size() - 1;
    for (std::size_t i = 0; i < last && any(which); ++i) {
        M here = no_lanes();
        for (int w = 0; w < program_.words; ++w)
            here = here | shares(list.word[w], U(stacks_.places(i)[std::size_t(w)]));
        here = here & which;
        push(stacks_.bins[i], batch, here, child, list, false);
        which = but_not(which, here);
    }
    push(stacks_.bins[last], batch, which, child, list, false);
}

inline WaitingRay Kernel::waiting(RayStack& stack, std::size_t at, bool is_shadow) const {
    using Stack = RayStack;
    WaitingRay ray;
    ray.origin = {stack[Stack::ox][at], stack[Stack::oy][at], stack[Stack::oz][at]};
    ray.direction = {stack[Stack::dx][at], stack[Stack::dy][at], stack[Stack::dz][at]};
    ray.weight = is_shadow ? 1.0 : stack[Stack::weight][at];
    ray.throughput = geom::Vec3{ray.weight};
    if (has_colour(is_shadow))
        ray.throughput = {stack[Stack::red][at], stack[Stack::green][at], stack[Stack::blue][at]};
    if (is_shadow) ray.t_max = stack[Stack::t_max][at];
    if (program_.attenuates) ray.way_before = stack[Stack::way][at];
    const std::uint64_t code = stack.word(Stack::code)[at];
    ray.code = code & ~RayCode::birth_mask;
    ray.birth_magnitude = RayCode::birth(code);
    if (has_key(is_shadow)) ray.key = stack.word(Stack::key)[at];
    for (int w = 0; w < program_.words; ++w)
        ray.inside[std::size_t(w)] = stack.word(Stack::Field(Stack::inside + w))[at];
    ray.contacts = stack.word(Stack::contacts)[at];
    if (!program_.groups.empty()) ray.sphere_contacts = stack.word(Stack::sphere_contacts)[at];
    if (program_.has_meshes) ray.mesh_contacts = stack.word(Stack::mesh_contacts)[at];
    return ray;
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
