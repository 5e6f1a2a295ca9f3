#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "geom/transform.hpp"
#include "scene/color.hpp"

namespace meniscus::scene {

struct Pigment;

/// `color_map` or `pigment_map`: entries sorted by position; between two, colours blend linearly.
/// Of two entries at one position, the first holds there. Ends are clamped.
struct ColorMap {
    struct Entry {
        double position;
        Color color;
    };
    std::vector<Entry> entries;
};
struct PigmentMap {
    struct Entry {
        double position;
        std::shared_ptr<const Pigment> pigment;
    };
    std::vector<Entry> entries;
};

struct SolidColor {
    Color color;
};
/// A list pattern hands out whole pigments by index: checker 2, hexagon 3, brick 2 (mortar first,
/// brick second).
struct Checker {
    std::shared_ptr<const Pigment> first, second;
};
struct Hexagon {
    std::shared_ptr<const Pigment> first, second, third;
};
struct Brick {
    std::shared_ptr<const Pigment> mortar, brick;
    geom::Vec3 size{8.0, 3.0, 4.5};
    double mortar_width = 0.5;
};
/// A value in [0, 1] of the position along `direction` (POV-Ray's gradient: each axis contributes),
/// looked up in a map.
struct Gradient {
    geom::Vec3 direction{1.0, 0.0, 0.0};
    double frequency = 1.0, phase = 0.0;
    std::variant<ColorMap, PigmentMap> map;
    enum class Wave { ramp, triangle, sine, scallop, cubic, poly } wave = Wave::ramp;
    double exponent = 1.0;  // of poly_wave
};

/// A colour at each point of space. `transform` takes the pigment's own frame to the frame of what
/// uses it.
struct Pigment {
    std::variant<SolidColor, Checker, Hexagon, Brick, Gradient> pattern;
    geom::Transform transform;
    /// `quick_color` and the like are dropped by the reader; nothing else hides here.
};

/// POV-Ray's `reflection { min, max fresnel falloff exponent metallic }`.
struct Reflection {
    Rgb min{0.0}, max{0.0};
    bool fresnel = false;
    double falloff = 1.0;
    double exponent = 1.0;
    double metallic = 0.0;
    bool is_active() const { return min != Rgb{0.0} || max != Rgb{0.0}; }
};

/// POV-Ray's finish, with its defaults. `albedo` forms are resolved by the reader into plain
/// numbers.
struct Finish {
    Rgb ambient{0.1};
    Rgb emission{0.0};
    double diffuse = 0.6;
    double brilliance = 1.0;
    double phong = 0.0, phong_size = 40.0;
    double specular = 0.0, roughness = 0.05;
    double metallic = 0.0;
    Reflection reflection;
    bool conserve_energy = false;
    double crand = 0.0;
    bool irid = false;  // read, not rendered
};

/// What a surface looks like. `clear` is the skin of `material { ior ... }`: transmit 1, exact
/// Fresnel reflection, nothing else. The transform takes the texture's frame to the world; the
/// pigment's own comes before it.
struct Texture {
    Pigment pigment;
    Finish finish;
    geom::Transform transform;
    bool clear = false;

    static Texture clear_skin() {
        Texture texture;
        texture.clear = true;
        return texture;
    }
};

/// Whether any colour of the pigment lets light through (filter or transmit not 0).
bool lets_light_through(const Pigment& pigment);

}  // namespace meniscus::scene
