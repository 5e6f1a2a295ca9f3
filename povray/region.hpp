#pragma once

#include <optional>
#include <string>
#include <vector>

#include "povray/export.hpp"
#include "povray/plan.hpp"

namespace meniscus::povray {

/// What is taken away from a body, and the texture that its own faces get there.
struct Cutter {
    scene::Object object;
    std::size_t texture;                  // of the scene, or `clear_skin`
    std::optional<scene::Object> within;  // only what of it lies in there
    std::optional<int> from;              // of the body's parts only this one; else from all
};

/// The texture of a film's face, which no object of the scene has.
inline constexpr std::size_t clear_skin = std::size_t(-1);

/// By how much a body is made larger: in contact with others, bubbles apart, by a hair, so that it
/// reaches into them. Scene units.
double growth(const Plan& plan, const Body& body, Model model, double hair);

/// What is above a body and overlaps or touches it: smaller by more than a hair in contact, larger
/// by the gap for films, and more where an opaque solid touches it. Adds to `warnings` where a
/// curved wall that both have in common leaves a skin. `sliver` keeps faces apart
/// (coincidence.hpp).
std::vector<Cutter> cutters(const tracer::RenderScene& scene, const Plan& plan, const Body& body,
                            Model model, double hair, double sliver,
                            std::vector<std::string>& warnings);

}  // namespace meniscus::povray
