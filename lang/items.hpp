#pragma once

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "geom/shape.hpp"
#include "geom/transform.hpp"
#include "lang/boxed.hpp"
#include "lang/source.hpp"
#include "scene/camera.hpp"
#include "scene/interior.hpp"
#include "scene/light.hpp"
#include "scene/scene.hpp"
#include "scene/texture.hpp"

/// The scene items that a file can declare, modify and use: what the blocks of the language mean.
namespace meniscus::lang {

/// Something of POV-Ray's that is read but cannot be rendered here. It is an error only once it is
/// used.
struct Refusal {
    std::string what;  // the word
    Span where;
    std::string advice;  // what to write instead, if anything
};

/// How much a pigment holds, which names for pigments let grow without many words.
struct PigmentSize {
    int depth = 1;       // of pigments in maps
    double parts = 1.0;  // pigments, itself included

    void add(const PigmentSize& part) {
        depth = std::max(depth, part.depth + 1);
        parts += part.parts;
    }
};

struct PigmentItem {
    scene::Pigment pigment;
    std::optional<Refusal> refusal;
    PigmentSize size;
};

struct FinishItem {
    scene::Finish finish;
    std::optional<double> ior;  // the old place of `ior`
    std::optional<double> caustics;
    std::optional<Refusal> refusal;
};

struct NormalItem {
    std::optional<Refusal> refusal;
};

struct TextureItem {
    PigmentItem pigment;
    FinishItem finish;
    NormalItem normal;
    geom::Transform transform;
    bool has_layer_below = false;  // harmless while this one is opaque
    std::optional<Refusal> refusal;
    Span span;
};

struct InteriorItem {
    scene::Interior interior;
    std::optional<Refusal> refusal;
};

struct MaterialItem {
    std::optional<TextureItem> texture;
    std::optional<InteriorItem> interior;
    bool is_short = false;  // material { ior ... }: without a texture, the skin is clear
};

struct MapItem {
    std::variant<scene::ColorMap, scene::PigmentMap> map;
    std::optional<Refusal> refusal;
    PigmentSize size;
};

struct TransformItem {
    geom::Transform transform;
};

struct CameraItem {
    scene::Camera::Kind kind = scene::Camera::Kind::perspective;
    geom::Vec3 location{0.0}, direction{0.0, 0.0, 1.0}, right{1.33, 0.0, 0.0}, up{0.0, 1.0, 0.0},
        sky{0.0, 1.0, 0.0};
    std::optional<geom::Vec3> look_at;
    std::optional<double> angle_degrees;
    bool states_size = false;  // right or up is given
    geom::Transform transform;
    std::optional<Refusal> refusal;
};

struct SkyItem {
    scene::SkySphere sky;
    std::optional<Refusal> refusal;
};

struct ObjectItem;

struct LightItem {
    scene::Light light;
    std::vector<std::shared_ptr<const ObjectItem>> looks_like;
    std::optional<Refusal> refusal;
    Span span;
};

/// Several objects taken together.
struct Union {
    std::vector<std::shared_ptr<const ObjectItem>> members;
};

/// A mesh whose triangles are in a file, which is loaded when the mesh enters the scene.
struct MeshFile {
    std::string name;  // as written
    std::filesystem::path path;
    Span span;
};

/// A shape, a union or a light, with what was said about it so far. A texture's transform is part
/// of the texture.
struct ObjectItem {
    std::variant<geom::Shape, MeshFile, Union, LightItem, Refusal> body;
    std::string keyword;  // as written: "sphere"
    std::string name;     // of the declaration it came from
    Span declared_at;     // that declaration's name
    Span span;
    geom::Transform transform;
    Boxed<TextureItem> texture;
    Boxed<InteriorItem> interior;
    bool clear = false;  // the skin of a material without texture
    bool inverse = false, no_shadow = false, no_image = false, no_reflection = false;
    bool double_illuminate = false, hollow = false;
    Boxed<Refusal> refusal;
    int depth = 1;
};

}  // namespace meniscus::lang
