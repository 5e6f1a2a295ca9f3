// error_table [LINES [SEED]]: prints the table of docs/numerics.md: for each kind of shape and
// placement, the worst error of a crossing along the normal in units of u M, over so many lines
// (25,000 unless stated).
#include <cstdlib>
#include <iostream>

#include "tests/geom/error_census.hpp"

using namespace meniscus::geom;

int main(int argc, char** argv) {
    const int lines = argc > 1 ? std::atoi(argv[1]) : 25000;
    const auto seed = static_cast<unsigned>(argc > 2 ? std::atoi(argv[2]) : 1);
    std::cout.precision(2);
    std::cout << "| shape |";
    for (const Placement placement : all_placements) std::cout << ' ' << name(placement) << " |";
    std::cout << "\n|---|---|---|---|---|\n";
    for (const Kind kind : all_kinds) {
        std::cout << "| " << name(kind) << " |" << std::flush;
        for (const Placement placement : all_placements) {
            std::cout << ' ' << census(kind, placement, lines, seed).worst << " |" << std::flush;
        }
        std::cout << '\n';
    }
}
