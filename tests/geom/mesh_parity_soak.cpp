// mesh_parity_soak [LINES [SEED]]: how often closed meshes are not left as often as entered, over
// lines aimed at vertices and edges. 1e8 of them take half an hour.
#include <cstdlib>
#include <iostream>

#include "tests/geom/mesh_parity.hpp"

int main(int argc, char** argv) {
    const auto lines = static_cast<std::uint64_t>(argc > 1 ? std::atof(argv[1]) : 1e8);
    const auto seed = static_cast<unsigned>(argc > 2 ? std::atoi(argv[2]) : 1);
    const auto result = meniscus::geom::mesh_parity(lines, seed);
    std::cout << result.lines << " lines, " << result.crossings << " crossings, "
              << result.unbalanced << " unbalanced, " << result.out_of_turn << " out of turn\n";
    return result.unbalanced + result.out_of_turn == 0 ? 0 : 4;
}
