#include "scene/texture.hpp"

#include <algorithm>

namespace meniscus::scene {
namespace {

bool lets_light_through(const Color& color) { return color.filter != 0.0 || color.transmit != 0.0; }

bool lets_light_through(const ColorMap& map) {
    return std::ranges::any_of(map.entries,
                               [](const auto& entry) { return lets_light_through(entry.color); });
}
bool lets_light_through(const PigmentMap& map) {
    return std::ranges::any_of(
        map.entries, [](const auto& entry) { return scene::lets_light_through(*entry.pigment); });
}

bool lets_light_through(const SolidColor& p) { return lets_light_through(p.color); }
bool lets_light_through(const Checker& p) {
    return scene::lets_light_through(*p.first) || scene::lets_light_through(*p.second);
}
bool lets_light_through(const Hexagon& p) {
    return scene::lets_light_through(*p.first) || scene::lets_light_through(*p.second) ||
           scene::lets_light_through(*p.third);
}
bool lets_light_through(const Brick& p) {
    return scene::lets_light_through(*p.mortar) || scene::lets_light_through(*p.brick);
}
bool lets_light_through(const Gradient& p) {
    return std::visit([](const auto& map) { return lets_light_through(map); }, p.map);
}

}  // namespace

bool lets_light_through(const Pigment& pigment) {
    return std::visit([](const auto& pattern) { return lets_light_through(pattern); },
                      pigment.pattern);
}

}  // namespace meniscus::scene
