#include "tests/geom/lines.hpp"

namespace meniscus::geom {

Vec3 Dice::direction() {
    while (true) {
        const Vec3 d = point(1.0);
        const double square = glm::dot(d, d);
        if (square > 0.01 && square < 1.0) return d / glm::sqrt(square);
    }
}

std::vector<Ray> awkward_lines(int count, unsigned seed) {
    Dice dice(seed);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        switch (i % 4) {
            case 0: {
                const Vec3 d = dice.direction();
                rays.push_back({dice.point(1.2) - 3.0 * d, d});
                break;
            }
            case 1: {
                Vec3 d{0.0};
                d[dice.below(3)] = dice.below(2) == 0 ? 1.0 : -1.0;
                rays.push_back({dice.lattice_point() - 3.0 * d, d});
                break;
            }
            case 2: {
                const Vec3 origin = 4.0 * dice.direction();
                rays.push_back({origin, glm::normalize(dice.lattice_point() - origin)});
                break;
            }
            default: {  // nearly along an axis, from far away
                Vec3 d = 1e-7 * dice.direction();
                d[dice.below(3)] = 1.0;
                d = glm::normalize(d);
                rays.push_back({dice.point(1.2) - 100.0 * d, d});
            }
        }
    }
    return rays;
}

}  // namespace meniscus::geom
