#include "povray/plain.hpp"

namespace meniscus::povray {

scene::Scene without_priorities(scene::Scene scene) {
    for (auto& solid : scene.solids) {
        solid.interior.priority = 0.0;
        solid.interior.states_priority = false;
    }
    return scene;
}

}  // namespace meniscus::povray
