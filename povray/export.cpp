#include "povray/export.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "povray/apart.hpp"
#include "povray/error.hpp"
#include "povray/precision.hpp"
#include "povray/scale.hpp"
#include "povray/slits.hpp"
#include "povray/write_bodies.hpp"
#include "povray/write_surroundings.hpp"
#include "tracer/render_scene.hpp"

namespace meniscus::povray {
namespace {

/// What POV-Ray has no word for, in any model.
void check_outside(const scene::Scene& scene) {
    if (scene.settings.outside.attenuates()) {
        throw ExportError({},
                          "the outside absorbs, which POV-Ray cannot do for rays to the sky; let a "
                          "large solid do so");
    }
}

/// In POV-Ray's units: above the rounding of places some 1e4 away, below the least of its hits.
constexpr double sliver = 1e-7;

/// Solids nearer than this to each other overlap by a hair or are cut by a film (plan.cpp).
double least_slit(const tracer::RenderScene& scene, Model model, double hair) {
    return model == Model::plain ? 0.0 : std::min(hair, touching_distance(scene));
}

const char* explanation(Model model) {
    switch (model) {
        case Model::plain:
            return "as declared, without its priorities";
        case Model::contact:
            return "exact contact: solids overlap by a hair, and faces within others reflect "
                   "nothing";
        case Model::gap:
            break;
    }
    return "films of the outside's medium between solids";
}

}  // namespace

Exported export_scene(const scene::Scene& source, const ExportOptions& options) {
    check_outside(source);
    const auto scene = tracer::compile(source);
    Exported result;
    result.scale = options.scale.value_or(natural_scale(scene, options));
    if (options.model == Model::contact) result.overlap = least_overlap / result.scale;
    result.warnings = scale_warnings(scene, options, result.scale);
    if (source.settings.max_trace_level.value_or(0) > most_trace_levels) {
        result.warnings.push_back(
            fmt::format("max_trace_level is {} in the export, not {}: POV-Ray goes no deeper",
                        most_trace_levels, *source.settings.max_trace_level));
    }

    Writer writer;
    writer.line("// {}, for POV-Ray 3.7 by Meniscus:",
                options.source.empty() ? "A scene" : options.source);
    writer.line("// {}.", explanation(options.model));
    if (options.model == Model::gap) writer.line("// The films are {} thick.", number(options.gap));
    writer.line("#version 3.7;");
    writer.line("#declare S = {};  // the scale: POV-Ray sees no hit nearer than 1e-4",
                number(result.scale));
    writer.blank();
    write_surroundings(writer, source);
    const double hair = options.model == Model::gap ? options.gap : result.overlap;
    for (std::string& warning :
         write_bodies(writer, scene, options.model, hair, sliver / result.scale))
        result.warnings.push_back(std::move(warning));
    if (options.model == Model::gap && hair > 0.0 && hair <= scene.contact_tolerance) {
        result.warnings.push_back(fmt::format(
            "films of {:g} are none to Meniscus, by the scene's contact_tolerance of {:g}; POV-Ray "
            "is given them",
            hair, scene.contact_tolerance));
    }
    for (std::string& warning : slit_warnings(scene, least_slit(scene, options.model, hair)))
        result.warnings.push_back(std::move(warning));
    result.text = writer.text();
    return result;
}

}  // namespace meniscus::povray
