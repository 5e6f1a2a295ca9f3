// mesh_parity_soak [LINES [SEED]]: how often closed meshes are not left as often as entered, over
// lines aimed at vertices and edges, searched one after the other and together.
#include <cstdlib>
#include <iostream>

#include "tests/geom/mesh_parity.hpp"

int main(int argc, char** argv) {
    const auto lines = static_cast<std::uint64_t>(argc > 1 ? std::atof(argv[1]) : 1e8);
    const auto seed = static_cast<unsigned>(argc > 2 ? std::atoi(argv[2]) : 1);
    const auto [alone, in_turns, asked, ahead, differing, astray] =
        meniscus::geom::mesh_parity(lines, seed);
    std::cout << "alone: " << alone.lines << " lines, " << alone.crossings << " crossings, "
              << alone.unbalanced << " unbalanced, " << alone.out_of_turn << " out of turn\n"
              << "in turns: " << in_turns.lines << " lines, " << in_turns.crossings
              << " crossings, " << in_turns.unbalanced << " unbalanced\n"
              << "ahead: " << asked << " asked, " << ahead.lines << " sure, " << ahead.crossings
              << " crossings, " << ahead.unbalanced << " unbalanced, " << ahead.out_of_turn
              << " out of turn, " << astray << " not the whole line's\n"
              << "otherwise in turns than alone: " << differing << '\n';
    const bool is_sound = alone.unbalanced + alone.out_of_turn + in_turns.unbalanced +
                              ahead.unbalanced + ahead.out_of_turn + differing + astray ==
                          0;
    return is_sound ? 0 : 4;
}
