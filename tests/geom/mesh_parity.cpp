#include "tests/geom/mesh_parity.hpp"

#include <vector>

#include "tests/geom/lines.hpp"
#include "tests/geom/meshes.hpp"

namespace meniscus::geom {

namespace {

Ray aimed_line(const TriangleMesh& mesh, Dice& dice) {
    const int count = static_cast<int>(mesh.size());
    const auto corners = mesh.corners(dice.below(count));
    const int kind = dice.below(4);
    Vec3 target = corners[0];
    if (kind == 1) target = 0.5 * (corners[0] + corners[1]);
    if (kind == 2) target = corners[0] + dice.between(0.0, 1.0) * (corners[1] - corners[0]);
    Vec3 d = dice.direction();
    if (dice.below(5) == 0) {
        d = Vec3{0.0};
        d[dice.below(3)] = dice.below(2) == 0 ? 1.0 : -1.0;
    }
    if (kind == 3) {
        const Vec3 way = mesh.corners(dice.below(count))[1] - target;
        if (glm::length(way) > 0.0) d = glm::normalize(way);
    }
    const double distances[] = {0.0, 2.0, 4.0, 1e4};
    return {target - distances[dice.below(4)] * d, d};
}

}  // namespace

Parity mesh_parity(std::uint64_t lines, unsigned seed) {
    std::vector<TriangleMesh> meshes;
    for (const Vec3& place : {Vec3{0.0}, Vec3{148376.0, 1234.0, -223423.0}}) {
        TriangleSoup ring = torus_mesh(96, 48);
        for (Vec3& p : ring.positions) p += place;
        meshes.emplace_back(icosphere(2, 1.0, place));
        meshes.emplace_back(gridded_box(7, place - Vec3{1.0}, place + Vec3{1.0, 0.5, 0.7}));
        meshes.emplace_back(ring);
        meshes.emplace_back(icosphere(6, 1.0, place));  // 81,920 triangles
    }
    Dice dice(seed);
    Parity result;
    Crossings found;
    for (; result.lines < lines; ++result.lines) {
        const TriangleMesh& mesh = meshes[result.lines % meshes.size()];
        found.clear();
        mesh.crossings(aimed_line(mesh, dice), found);
        result.crossings += found.size();
        int balance = 0;
        bool takes_turns = true;
        for (std::size_t i = 0; i < found.size(); ++i) {
            balance += found[i].entering ? 1 : -1;
            takes_turns &= found[i].entering == (i % 2 == 0);
        }
        result.unbalanced += balance != 0;
        result.out_of_turn += !takes_turns;
    }
    return result;
}

}  // namespace meniscus::geom
