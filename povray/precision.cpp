#include "povray/precision.hpp"

namespace meniscus::povray {

scene::Scene with_povrays_iors(scene::Scene scene) {
    const double outside = scene.settings.outside.ior;
    for (auto& solid : scene.solids)
        solid.interior.ior = outside * double(float(solid.interior.ior / outside));
    return scene;
}

}  // namespace meniscus::povray
