#include <cmath>
#include <stdexcept>
#include <vector>

#include "geom/profile.hpp"
#include "povray/cut_profile.hpp"
#include "povray/grow.hpp"

namespace meniscus::povray {
namespace {

using geom::Vec2;

/// The less a curve bends, the less its control polygon's offset falls short of its own: of a
/// quarter turn by a tenth of the distance, of a fourth of it by less than a hundredth.
constexpr int cuts_of_a_curve = 4;

/// One run of joined pieces as the legs of its control polygon.
struct Chain {
    std::vector<Vec2> points;     // four a piece, joints twice
    std::vector<double> outward;  // of each piece
    bool is_loop = false;
};

std::vector<Chain> chains_of(const geom::Profile& profile) {
    std::vector<Chain> chains;
    Vec2 end{0.0};
    for (const auto& piece : profile.pieces()) {
        if (chains.empty() || piece.start != end) chains.emplace_back();
        const auto points = cut(piece, piece.straight ? 1 : cuts_of_a_curve);
        chains.back().points.insert(chains.back().points.end(), points.begin(), points.end());
        chains.back().outward.insert(chains.back().outward.end(), points.size() / 4, piece.outward);
        end = piece.end;
    }
    for (auto& chain : chains) chain.is_loop = chain.points.front() == chain.points.back();
    return chains;
}

/// A line that a leg lies on after the move: n . p = c.
struct Line {
    Vec2 n;
    double c;
};

/// Where two lines meet; along one and the same line, the point of it nearest to `p`.
Vec2 meet(const Line& a, const Line& b, const Vec2& p, double distance) {
    const double determinant = a.n.x * b.n.y - a.n.y * b.n.x;
    if (std::abs(determinant) < 1e-6 && glm::dot(a.n, b.n) > 0.0)
        return p + (a.c - glm::dot(a.n, p)) * a.n;
    if (std::abs(determinant) < 1e-12) throw std::invalid_argument("its profile has a cusp");
    const Vec2 q = Vec2{a.c * b.n.y - b.c * a.n.y, a.n.x * b.c - b.n.x * a.c} / determinant;
    if (glm::length(q - p) > 20.0 * std::abs(distance))
        throw std::invalid_argument("its profile has too sharp a corner");
    return q;
}

}  // namespace

geom::Lathe offset(const geom::Lathe& lathe, double distance) {
    const geom::Profile profile(lathe.spline(), lathe.points());
    const double small = 1e-12 * profile.size();
    std::vector<Vec2> result;
    bool is_straight = true;
    const auto chains = chains_of(profile);
    for (const auto& piece : profile.pieces()) is_straight = is_straight && piece.straight;
    for (const Chain& chain : chains) {
        const auto& p = chain.points;
        // Legs of no length stand for nothing; each point lies between the legs before and behind.
        std::vector<Line> lines;
        std::vector<std::size_t> leg_before(p.size()), leg_behind(p.size());
        std::vector<int> leg(p.size(), -1);  // of the leg from point i to i + 1
        for (std::size_t i = 0; i + 1 < p.size(); ++i) {
            const Vec2 along = p[i + 1] - p[i];
            if (glm::length(along) <= small) continue;
            const Vec2 n = chain.outward[i / 4] * glm::normalize(Vec2{along.y, -along.x});
            const bool on_axis = p[i].x <= small && p[i + 1].x <= small;
            leg[i] = int(lines.size());
            lines.push_back({n, glm::dot(n, p[i]) + (on_axis ? 0.0 : distance)});
        }
        const Line axis{{-1.0, 0.0}, 0.0};
        std::vector<Vec2> moved(p.size());
        for (std::size_t i = 0; i < p.size(); ++i) {
            int before = -1, behind = -1;
            for (std::size_t j = i; j-- > 0 && before < 0;) before = leg[j];
            for (std::size_t j = i; j < p.size() && behind < 0; ++j) behind = leg[j];
            if (before < 0 && chain.is_loop) before = int(lines.size()) - 1;
            if (behind < 0 && chain.is_loop) behind = 0;
            const Line& a = before < 0 ? lines[std::size_t(behind)] : lines[std::size_t(before)];
            const Line& b = behind < 0 ? lines[std::size_t(before)] : lines[std::size_t(behind)];
            // An end on the axis stays there, wherever the legs meet it.
            const bool is_end = before < 0 || behind < 0;
            moved[i] = is_end ? meet(a, std::abs(a.n.y) < 1e-9 ? a : axis, p[i], distance)
                              : meet(a, b, p[i], distance);
            if (p[i].x <= small || moved[i].x < 0.0) moved[i].x = 0.0;
        }
        for (std::size_t i = 0; i + 3 < p.size(); i += 4) {
            if (is_straight && chains.size() == 1) {
                if (i == 0) result.push_back(moved[0]);
                result.push_back(moved[i + 3]);
            } else {
                result.insert(result.end(), moved.begin() + std::ptrdiff_t(i),
                              moved.begin() + std::ptrdiff_t(i) + 4);
            }
        }
    }
    return {is_straight && chains.size() == 1 ? geom::Spline::linear : geom::Spline::bezier,
            std::move(result)};
}

}  // namespace meniscus::povray
