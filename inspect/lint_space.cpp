#include <fmt/format.h>

#include <algorithm>

#include "inspect/lints.hpp"
#include "tracer/camera_rays.hpp"

namespace meniscus::inspect {
namespace {

using geom::Vec3;
using tracer::Part;
using tracer::RenderScene;

bool contains(const Part& part, const Vec3& p) {
    return part.shape.is_closed() && part.shape.contains(p) != part.inverse;
}

bool has_sky(const scene::Scene& scene) {
    return scene.background.rgb != scene::Rgb{0.0} || !scene.sky_sphere.pigments.empty();
}

}  // namespace

void find_camera_in_media(const RenderScene& scene, const Names& names,
                          std::vector<Finding>& findings) {
    const Vec3 p = tracer::camera_origin(scene.source.camera);
    for (const Part& part : scene.parts) {
        if (!part.is_member || part.is_opaque || part.no_image || !contains(part, p)) continue;
        // The complement of a lens's face, as air, is where a camera belongs.
        const scene::Scene& source = scene.source;
        const auto& interior = source.solids[std::size_t(part.solid)].interior;
        if (interior.same_medium(source.settings.outside)) continue;
        Finding finding;
        finding.severity = Finding::Severity::note;
        finding.lint = "camera-inside";
        finding.location = scene.source.objects[std::size_t(part.object)].location;
        finding.text =
            fmt::format("the camera at {} is inside {}", text(p), names.with_priority(part.solid));
        finding.advice = "nothing need be done if that is meant: rays start in there";
        finding.position = p;
        findings.push_back(std::move(finding));
    }
}

void find_camera_in_opaque(const RenderScene& scene, const Names& names,
                           std::vector<Finding>& findings) {
    const Vec3 p = tracer::camera_origin(scene.source.camera);
    for (const Part& part : scene.parts) {
        if (!part.is_opaque || part.no_image || !contains(part, p)) continue;
        Finding finding;
        finding.severity = Finding::Severity::note;
        finding.lint = "camera-inside-opaque";
        finding.location = scene.source.objects[std::size_t(part.object)].location;
        finding.text = fmt::format(
            "the camera at {} is inside {}, which is opaque: it sees nothing beyond its surface",
            text(p), names.object(part.object));
        finding.advice = "nothing need be done if that is meant, as of a backdrop round the scene";
        finding.position = p;
        findings.push_back(std::move(finding));
    }
}

void find_lost_sky(const RenderScene& scene, const Names&, std::vector<Finding>& findings) {
    const scene::Interior& outside = scene.source.settings.outside;
    constexpr std::string_view channel_names[] = {"red", "green", "blue"};
    std::string channels;
    for (int i = 0; i < 3; ++i) {
        const bool absorbs = outside.absorption[i] > 0.0;
        const bool fades =
            outside.fade.is_active() && outside.fade.power >= 1000.0 && outside.fade.color[i] < 1.0;
        if (!absorbs && !fades) continue;
        channels += fmt::format("{}{}", channels.empty() ? "" : ", ", channel_names[i]);
    }
    if (channels.empty()) return;
    Finding finding;
    if (!has_sky(scene.source)) finding.severity = Finding::Severity::note;
    finding.lint = "sky-absorbed";
    finding.location = scene.source.settings.outside_location;
    finding.text = fmt::format(
        "the space outside everything absorbs, and the sky is infinitely far away: background and "
        "sky_sphere are 0 in {}",
        channels);
    finding.advice =
        "put the absorbing medium into a solid of its own (a big sphere), or put the sky on one";
    findings.push_back(std::move(finding));
}

void find_buried_lights(const RenderScene& scene, const Names& names,
                        std::vector<Finding>& findings) {
    for (const scene::Light& light : scene.source.lights) {
        if (light.shadowless) continue;
        for (const Part& part : scene.parts) {
            if (!part.is_opaque || part.no_shadow || !contains(part, light.position)) continue;
            // In a backdrop round everything, the camera is as well.
            if (contains(part, tracer::camera_origin(scene.source.camera))) continue;
            Finding finding;
            finding.lint = "buried-light";
            finding.location = light.location;
            finding.text = fmt::format(
                "the light at {} is inside {}, which is opaque: it lights nothing outside",
                text(light.position), names.object(part.object));
            finding.advice =
                fmt::format("move the light, or give {} `no_shadow`", names.object(part.object));
            finding.related = {{scene.source.objects[std::size_t(part.object)].location,
                                names.object(part.object) + " is here"}};
            finding.position = light.position;
            findings.push_back(std::move(finding));
        }
    }
}

}  // namespace meniscus::inspect
