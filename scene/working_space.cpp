#include "scene/working_space.hpp"

#include <algorithm>
#include <cmath>

namespace meniscus::scene {
namespace {

double srgb_of_light(double light) {
    return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
}

}  // namespace

double light_of_srgb(double number) {
    return number <= 0.04045 ? number / 12.92 : std::pow((number + 0.055) / 1.055, 2.4);
}

double WorkingSpace::to_light(double number) const {
    if (is_linear()) return number;
    return is_srgb ? light_of_srgb(number) : std::pow(std::max(number, 0.0), gamma);
}

double WorkingSpace::from_light(double light) const {
    if (is_linear()) return light;
    return is_srgb ? srgb_of_light(light) : std::pow(std::max(light, 0.0), 1.0 / gamma);
}

}  // namespace meniscus::scene
