#pragma once

#include <optional>

#include "povray/plan.hpp"

namespace meniscus::povray {

/// How thick films really are, measured from points of what they cover.
struct Thickness {
    double least, largest;
};

struct Filmed {
    scene::Scene scene;
    std::optional<Thickness> thickness;  // none if no solid has a lower neighbour
};

/// The gap model as a scene of our own: each solid that cuts a lower one gets a film round it, the
/// solid made larger by `gap` (scene units) and filled with the outside's medium, of a priority
/// just below its own. Opaque surfaces that a dielectric stands on get one as well.
Filmed with_films(scene::Scene scene, double gap);

/// The parts that a body's film consists of: `grown`, or its own where it is of the outside's
/// medium anyhow.
scene::Object film_part(const tracer::RenderScene& scene, const Body& body, int part, double gap);

}  // namespace meniscus::povray
