#pragma once

#include <cstdint>

namespace meniscus::geom {

/// What is true of the crossings of many lines.
struct ParityCount {
    std::uint64_t lines = 0, crossings = 0;
    std::uint64_t unbalanced = 0;   // not entered as often as left
    std::uint64_t out_of_turn = 0;  // entering and leaving do not take turns
};

struct Parity {
    ParityCount alone;            // whole lines, one after the other
    ParityCount in_turns;         // the same, searched together; these are not put in order
    std::uint64_t asked = 0;      // rays that ask together for what lies ahead of them
    ParityCount ahead;            // those of them that are sure of it
    std::uint64_t differing = 0;  // other crossings together than alone, by a bit
    std::uint64_t astray = 0;     // sure of what is not the whole line's
};

/// Shoots lines at the vertices and edges of closed meshes: an icosphere, a gridded box, a torus
/// and a large icosphere, about the origin and at (148376, 1234, -223423), and the latter two with
/// coordinates that are floats. A quarter of the lines each: through a vertex, through the middle
/// of an edge, through any point of an edge, from a vertex to another; a fifth of them along an
/// axis; from near, far and from the surface itself. Each line is searched alone and together with
/// others; and as a ray that knows, or believes to know, where it starts.
Parity mesh_parity(std::uint64_t lines, unsigned seed);

}  // namespace meniscus::geom
