#include "povray/write_interior.hpp"

#include "povray/error.hpp"
#include "povray/write_texture.hpp"

namespace meniscus::povray {

std::string interior(const scene::Solid& solid, const scene::Interior& outside, Model model) {
    const auto& it = solid.interior;
    std::string words = "ior " + number(it.ior / outside.ior);
    scene::Rgb absorption = it.absorption;
    if (it.fade.is_active()) {
        if (model == Model::plain) {
            words +=
                fmt::format(" fade_distance {} fade_power {} fade_color {}",
                            length(it.fade.distance), number(it.fade.power), color(it.fade.color));
        } else if (it.fade.power >= 1000.0) {
            absorption += (scene::Rgb{1.0} - it.fade.color) / it.fade.distance;
        } else {
            throw ExportError(solid.location,
                              "fade_power below 1000 cannot be exported: POV-Ray fades only what "
                              "is refracted; use absorption, or --model plain");
        }
    }
    if (absorption != scene::Rgb{0.0})
        words += fmt::format(" media {{ absorption {}/S }}", color(absorption));
    if (it.caustics != 0.0) words += " caustics " + number(it.caustics);
    return fmt::format("interior {{ {} }}", words);
}

}  // namespace meniscus::povray
