#include "tracer/lane_paints.hpp"

#include <algorithm>
#include <optional>

namespace meniscus::tracer {
namespace {

/// A colour that lets nothing through.
const geom::Vec3* plain_colour(const scene::Pigment& pigment) {
    const auto* solid = std::get_if<scene::SolidColor>(&pigment.pattern);
    return solid && solid->color.filter == 0.0 && solid->color.transmit == 0.0 ? &solid->color.rgb
                                                                               : nullptr;
}

/// The texture of a surface that lanes can shade.
std::optional<lanes::Paint> make_paint(const RenderScene& scene, const Part& part) {
    const scene::Texture& texture = texture_of(scene, part);
    const scene::Finish& finish = texture.finish;
    if (texture.clear || part.double_illuminate || part.no_shadow || finish.phong != 0.0 ||
        finish.specular != 0.0 || finish.brilliance != 1.0 || finish.crand != 0.0 ||
        finish.reflection.is_active())
        return std::nullopt;
    lanes::Paint paint;
    const auto* checker = std::get_if<scene::Checker>(&texture.pigment.pattern);
    paint.is_checker = checker != nullptr;
    const geom::Vec3* colours[2] = {plain_colour(checker ? *checker->first : texture.pigment),
                                    plain_colour(checker ? *checker->second : texture.pigment)};
    if (!colours[0] || !colours[1]) return std::nullopt;
    for (int i = 0; i < 2; ++i) paint.colours[i] = *colours[i];
    const geom::Transform &inner = texture.pigment.transform, &outer = texture.transform;
    paint.to_cells = inner.inverse_linear() * outer.inverse_linear();
    paint.shift = -(paint.to_cells * outer.shift() + inner.inverse_linear() * inner.shift());
    paint.glow = finish.ambient * scene.source.settings.ambient_light + finish.emission;
    paint.diffuse = finish.diffuse;
    paint.is_open =
        scene.lone_floor != outside && &part == &scene.parts[std::size_t(scene.lone_floor)];
    return paint;
}

}  // namespace

const scene::Texture& texture_of(const RenderScene& scene, const Part& part) {
    return scene.source.textures[scene.source.objects[std::size_t(part.object)].texture];
}

void make_paints(const RenderScene& scene, lanes::Program& program) {
    for (const scene::Light& light : scene.source.lights) {
        const bool fades = light.fade_distance > 0.0 && light.fade_power > 0.0;
        if (light.kind != scene::Light::Kind::point || light.parallel || light.shadowless || fades)
            return;
        program.lights.push_back({light.position, light.color});
    }
    for (lanes::Solid& solid : program.solids) {
        if (solid.rank >= 0) continue;
        const auto paint = make_paint(scene, scene.parts[std::size_t(solid.part)]);
        if (!paint) continue;
        solid.paint = int(program.paints.size());
        program.paints.push_back(*paint);
    }
    program.all_painted = std::ranges::all_of(
        program.solids, [](const auto& solid) { return solid.rank >= 0 || solid.paint >= 0; });
}

}  // namespace meniscus::tracer
