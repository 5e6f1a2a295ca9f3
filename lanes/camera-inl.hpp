// Camera rays, made in lanes: the formulas are those of tracer/camera_rays.hpp.

#if defined(MENISCUS_LANES_CAMERA) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_CAMERA
#undef MENISCUS_LANES_CAMERA
#else
#define MENISCUS_LANES_CAMERA
#endif

#include "lanes/kernel-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

/// Pushes some further camera rays, none when all are under way.
inline void Kernel::add_camera_rays() {
    using Stack = RayStack;
    // Some more than a step takes: to add them has a cost of its own.
    constexpr std::size_t wanted = 4 * lanes;
    const Camera* const camera = host_.camera();
    if (!camera) return host_.more_rays(stacks_, wanted);
    RayStack& stack = stacks_.bin_of(camera->start.inside);
    static_assert(wanted <= FilmPoints::most);
    const std::size_t count = host_.more_points(points_, wanted);
    const std::size_t first = stack.grow(count);
    const WaitingRay& start = camera->start;
    const U birth(RayCode::of_birth(start.birth_magnitude));
    for (std::size_t i = 0; i < count; i += lanes) {
        const std::size_t at = first + i;
        const auto numbers = [&](Stack::Field field, F x) HWY_ATTR { store(x, stack[field] + at); };
        const auto words = [&](Stack::Field field, U x)
                               HWY_ATTR { store(x, stack.word(field) + at); };
        const F a = load(points_.x + i) / F(camera->width) - F(0.5);
        const F b = F(0.5) - load(points_.y + i) / F(camera->height);
        const F3 towards = F3(camera->forward) + (a * F3(camera->right) + b * F3(camera->up));
        const F3 direction = (F(1.0) / sqrt(dot(towards, towards))) * towards;
        numbers(Stack::ox, F(start.origin.x));
        numbers(Stack::oy, F(start.origin.y));
        numbers(Stack::oz, F(start.origin.z));
        numbers(Stack::dx, direction.x);
        numbers(Stack::dy, direction.y);
        numbers(Stack::dz, direction.z);
        numbers(Stack::weight, F(start.weight));
        words(Stack::code, load(points_.pixel + i) | birth);
        words(Stack::contacts, U(start.contacts));
        for (int w = 0; w < program_.words; ++w)
            words(Stack::Field(Stack::inside + w), U(start.inside[std::size_t(w)]));
        if (has_colour(false)) {
            const F light = load(points_.weight + i);
            numbers(Stack::red, light);
            numbers(Stack::green, light);
            numbers(Stack::blue, light);
        }
        if (program_.attenuates) numbers(Stack::way, F(start.way_before));
        if (has_key(false)) words(Stack::key, load(points_.key + i));
        if (!program_.groups.empty()) words(Stack::sphere_contacts, U(start.sphere_contacts));
        if (program_.has_meshes) words(Stack::mesh_contacts, U(start.mesh_contacts));
    }
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
