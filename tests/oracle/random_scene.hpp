#pragma once

#include <cstdint>

#include "scene/scene.hpp"

namespace meniscus::oracle {

/// What a random scene may hold. All its coordinates and sizes are multiples of one half (unless
/// scattered), so that shared faces, edges and points of tangency are the rule; the camera and the
/// lamp are not on that lattice.
struct RandomSceneOptions {
    int fewest_solids = 3, most_solids = 8;
    bool rotated = false;    // all under one rotation, each solid with an origin of its own
    bool stretched = false;  // each solid under a scaling of its own
    bool sheared = false;    // all under one shear
    bool scattered = false;  // each solid moved off the lattice: nothing coincides
    bool cones = false;
    bool tori = false;
    bool lathes = false;
    bool meshes = false;
    bool unions = false;          // some solids are two shapes
    bool textured = false;        // some skins with pigments, filters and highlights
    bool opaque_members = false;  // some opaque solids with a priority
    bool complements = false;     // some solids are the inverse of their shape
    bool floor = true;            // an opaque half-space with a checker, and a lamp
    double scale = 1.0;           // of the whole scene
    geom::Vec3 offset{0.0};       // of the whole scene, after scaling
};

/// Every shape and every kind of scene in turn, with 2 to 12 solids: what a long run draws from.
RandomSceneOptions every_kind(std::uint64_t seed);

/// The same scene for the same seed, on every machine. No two solids have the same priority.
scene::Scene random_scene(std::uint64_t seed, const RandomSceneOptions& options = {});

/// The distance, in scene units, below which the oracle takes a random scene's surfaces to be in
/// contact: beyond what rounding moved them by.
double contact_of(const RandomSceneOptions& options);

}  // namespace meniscus::oracle
