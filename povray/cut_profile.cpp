#include "povray/cut_profile.hpp"

namespace meniscus::povray {

std::vector<geom::Vec2> cut(const geom::ProfilePiece& piece, int curves) {
    std::vector<geom::Vec2> points;
    for (int i = 0; i < curves; ++i) {
        const double from = double(i) / curves, to = double(i + 1) / curves;
        const double third = (to - from) / 3.0;
        const auto begin = i == 0 ? piece.start : piece.at(from);
        const auto end = i + 1 == curves ? piece.end : piece.at(to);
        points.insert(points.end(), {begin, begin + third * piece.tangent(from),
                                     end - third * piece.tangent(to), end});
    }
    return points;
}

}  // namespace meniscus::povray
