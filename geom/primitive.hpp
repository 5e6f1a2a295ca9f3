#pragma once

#include <concepts>
#include <string_view>
#include <tuple>

#include "geom/bounds.hpp"
#include "geom/crossing.hpp"
#include "geom/ray.hpp"

namespace meniscus::geom {

/// One argument of a primitive in the scene language: `sphere { center, radius }` has two of them,
/// in order.
template <class Owner, class Value>
struct Field {
    std::string_view name;
    Value Owner::*member;
    bool optional = false;  // the last ones only: may be left out, and then keep their default
};
template <class Owner, class Value>
Field(std::string_view, Value Owner::*) -> Field<Owner, Value>;
template <class Owner, class Value>
Field(std::string_view, Value Owner::*, bool) -> Field<Owner, Value>;

/// A word that may follow the arguments and sets a bool: `open`.
template <class Owner>
struct Flag {
    std::string_view keyword;
    bool Owner::*member;
};
template <class Owner>
Flag(std::string_view, bool Owner::*) -> Flag<Owner>;

/// What every shape offers in its own frame; its default value is the unit shape that the contract
/// tests use. `fields` is a tuple of Field and `flags` one of Flag: empty where the syntax is the
/// shape's own (mesh, lathe, polygon).
template <class T>
concept Primitive = std::default_initializable<T> &&
    requires(const T shape, const Ray ray, const Vec3 p, Face face) {
    { T::keyword } -> std::convertible_to<std::string_view>;
    T::fields;
    T::flags;
    { shape.is_closed() } -> std::same_as<bool>;
    { shape.bounds() } -> std::same_as<Bounds>;
    { shape.magnitude() } -> std::same_as<double>;
    { shape.normal(face, p) } -> std::same_as<Vec3>;
    { shape.to_face(face, ray) } -> std::same_as<Vec3>;
};

/// Closed and convex: `interval` says all.
template <class T>
concept Convex = Primitive<T> && requires(const T shape, const Ray ray, const Vec3 p, Face pin) {
    { shape.interval(ray, pin) } -> std::same_as<Interval>;
    { shape.contains(p) } -> std::same_as<bool>;
};

/// Closed, with any number of crossings along a line.
template <class T>
concept Solid = Primitive<T> &&
    requires(const T shape, const Ray ray, const Vec3 p, Crossings& out) {
    shape.crossings(ray, out);
    { shape.contains(p) } -> std::same_as<bool>;
};

/// Has an open form, which is only a surface (disc, triangle, `open` cylinder, mesh with holes).
template <class T>
concept Surface = Primitive<T> && requires(const T shape, const Ray ray, Crossings& out) {
    shape.hits(ray, out);
};

}  // namespace meniscus::geom
