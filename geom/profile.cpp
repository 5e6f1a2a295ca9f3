#include "geom/profile.hpp"

#include <algorithm>
#include <stdexcept>

#include "geom/polynomial.hpp"

namespace meniscus::geom {

namespace {

constexpr double end_of_u = 1.0;

std::array<double, 4> component(const std::array<Vec2, 4>& c, int axis) {
    return {c[0][axis], c[1][axis], c[2][axis], c[3][axis]};
}

/// Where a coordinate of the piece stands still, within (0, 1).
Roots still_points(const ProfilePiece& piece, int axis) {
    const std::array<double, 3> slope{piece.c[1][axis], 2.0 * piece.c[2][axis],
                                      3.0 * piece.c[3][axis]};
    Roots roots = roots_between(slope, 0.0, end_of_u);
    if (slope[2] == 0.0 && slope[1] != 0.0) {
        roots = roots_between(std::span{slope}.first<2>(), 0.0, end_of_u);
    }
    return roots;
}

ProfilePiece make_piece(const std::array<Vec2, 4>& c, const Vec2& start, const Vec2& end) {
    ProfilePiece piece{
        .c = c, .start = start, .end = end, .straight = false, .low = {}, .high = {}};
    piece.straight = c[2] == Vec2{0.0} && c[3] == Vec2{0.0};
    if (piece.straight) {
        const Vec2 along = glm::normalize(end - start);
        piece.line = {along.y, -along.x, along.y * start.x - along.x * start.y};
    }
    piece.low = glm::min(start, end);
    piece.high = glm::max(start, end);
    for (int axis = 0; axis < 2; ++axis) {
        for (const double u : still_points(piece, axis)) {
            piece.low[axis] = glm::min(piece.low[axis], piece.at(u)[axis]);
            piece.high[axis] = glm::max(piece.high[axis], piece.at(u)[axis]);
        }
    }
    return piece;
}

ProfilePiece straight_piece(const Vec2& p, const Vec2& q) {
    return make_piece({p, q - p, Vec2{0.0}, Vec2{0.0}}, p, q);
}

ProfilePiece quadratic_piece(const Vec2& before, const Vec2& p, const Vec2& q) {
    return make_piece({p, 0.5 * (q - before), 0.5 * before - p + 0.5 * q, Vec2{0.0}}, p, q);
}

/// Catmull-Rom.
ProfilePiece cubic_piece(const Vec2& before, const Vec2& p, const Vec2& q, const Vec2& after) {
    return make_piece({p, 0.5 * (q - before), before - 2.5 * p + 2.0 * q - 0.5 * after,
                       -0.5 * before + 1.5 * p - 1.5 * q + 0.5 * after},
                      p, q);
}

ProfilePiece bezier_piece(const Vec2& p, const Vec2& p1, const Vec2& p2, const Vec2& q) {
    // Four points in order on a line make a line.
    const Vec2 along = q - p;
    const auto is_on_line = [&](const Vec2& r) {
        const Vec2 e = r - p;
        return glm::abs(along.x * e.y - along.y * e.x) <= 1e-15 * glm::dot(along, along);
    };
    const double first = glm::dot(p1 - p, along), second = glm::dot(p2 - p, along);
    if (p != q && is_on_line(p1) && is_on_line(p2) && 0.0 <= first && first <= second &&
        second <= glm::dot(along, along)) {
        return straight_piece(p, q);
    }
    return make_piece({p, 3.0 * (p1 - p), 3.0 * (p - 2.0 * p1 + p2), (q - p) + 3.0 * (p1 - p2)}, p,
                      q);
}

void require(bool condition, const char* message) {
    if (!condition) throw std::invalid_argument(message);
}

}  // namespace

double ProfilePiece::nearest(const Vec2& p) const {
    if (straight) {
        const Vec2 along = end - start;
        return glm::clamp(glm::dot(p - start, along) / glm::dot(along, along), 0.0, 1.0);
    }
    // (c(u) - p) . c'(u) = 0
    std::array<double, 6> product{};
    for (int axis = 0; axis < 2; ++axis) {
        auto value = component(c, axis);
        value[0] -= p[axis];
        for (int i = 0; i < 4; ++i) {
            for (int j = 1; j < 4; ++j) product[i + j - 1] += value[i] * j * component(c, axis)[j];
        }
    }
    Roots tries = roots_between(product, 0.0, 1.0);
    tries.push_back(0.0);
    tries.push_back(1.0);
    double best = 0.0, best_distance = infinity;
    for (const double u : tries) {
        const Vec2 e = at(u) - p;
        if (const double distance = glm::dot(e, e); distance < best_distance) {
            best = u;
            best_distance = distance;
        }
    }
    return best;
}

Profile::Profile(Spline spline, const std::vector<Vec2>& p) {
    const std::size_t n = p.size();
    // A curve that ends where it began may be a loop; only a point is dropped.
    const auto add = [&](const ProfilePiece& piece) {
        const double rounding = 16.0 * unit_roundoff * glm::length(piece.start);
        const bool is_point = std::all_of(piece.c.begin() + 1, piece.c.end(), [&](const Vec2& c) {
            return glm::length(c) <= rounding;
        });
        if (!is_point) pieces_.push_back(piece);
    };
    switch (spline) {
        case Spline::linear:
            require(n >= 2, "a lathe with a linear_spline needs at least two points");
            for (std::size_t i = 0; i + 1 < n; ++i) add(straight_piece(p[i], p[i + 1]));
            break;
        case Spline::quadratic:
            require(n >= 3, "a lathe with a quadratic_spline needs at least three points");
            for (std::size_t i = 1; i + 1 < n; ++i) {
                add(quadratic_piece(p[i - 1], p[i], p[i + 1]));
            }
            break;
        case Spline::cubic:
            require(n >= 4, "a lathe with a cubic_spline needs at least four points");
            for (std::size_t i = 1; i + 2 < n; ++i) {
                add(cubic_piece(p[i - 1], p[i], p[i + 1], p[i + 2]));
            }
            break;
        case Spline::bezier:
            require(n >= 4 && n % 4 == 0, "a lathe with a bezier_spline needs four points a piece");
            for (std::size_t i = 0; i + 3 < n; i += 4) {
                add(bezier_piece(p[i], p[i + 1], p[i + 2], p[i + 3]));
            }
            break;
    }
    require(!pieces_.empty(), "all points of a lathe are the same");

    low_ = pieces_[0].low;
    high_ = pieces_[0].high;
    for (const ProfilePiece& piece : pieces_) {
        low_ = glm::min(low_, piece.low);
        high_ = glm::max(high_, piece.high);
    }
    size_ = glm::max(high_.x, high_.y - low_.y);
    for (const Vec2& q : {low_, high_}) {
        require(glm::abs(q.x) < infinity && glm::abs(q.y) < infinity,
                "a point of a lathe is not finite");
    }
    for (const ProfilePiece& piece : pieces_) {
        require(piece.start.x >= 0.0 && piece.end.x >= 0.0,
                "a point of a lathe has a negative radius");
    }

    close_chains();
    cut_into_arcs();
    if (closed_) {
        for (ProfilePiece& piece : pieces_) find_outward_side(piece);
    }
}

/// Ends that differ by rounding only are made the same; then each chain of pieces must close, alone
/// or through the axis.
void Profile::close_chains() {
    const double rounding = 1e-12 * size_;
    const auto same = [&](const Vec2& a, const Vec2& b) { return glm::length(a - b) <= rounding; };
    closed_ = true;
    for (std::size_t first = 0, last; first < pieces_.size(); first = last + 1) {
        last = first;
        while (last + 1 < pieces_.size() && same(pieces_[last].end, pieces_[last + 1].start)) {
            pieces_[last + 1].start = pieces_[last].end;
            ++last;
        }
        Vec2 &start = pieces_[first].start, &end = pieces_[last].end;
        if (same(start, end)) {
            end = start;
        } else if (glm::abs(start.x) <= rounding && glm::abs(end.x) <= rounding) {
            start.x = end.x = 0.0;
        } else {
            closed_ = false;
        }
    }
}

void Profile::cut_into_arcs() {
    std::vector<ProfileArc> cut;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        cut.clear();
        append_arcs(pieces_[i], static_cast<Face>(i), cut);
        first_arc_.push_back(arcs_.size());
        for (const ProfileArc& arc : cut) {
            if (!arcs_.empty() && arcs_.back().end != arc.start) arcs_.emplace_back();
            arcs_.push_back(arc);
        }
    }
    first_arc_.push_back(arcs_.size());
}

bool Profile::contains(const Vec2& p) const {
    bool inside = false;
    for (const ProfileArc& arc : arcs_) {
        // Half open, so that a line through a joint counts once.
        if ((arc.start.y <= p.y) == (arc.end.y <= p.y)) continue;
        if (p.x >= glm::max(arc.start.x, arc.end.x)) continue;
        if (p.x >= glm::min(arc.start.x, arc.end.x)) {
            double v = 0.0;
            if (!(arc.height(p) < arc.rise_at(arc.way(p), v).value)) continue;
        }
        inside = !inside;
    }
    return inside;
}

Profile::Foot Profile::foot(Face piece, const Vec2& p) const {
    const auto index = static_cast<std::size_t>(piece);
    Foot best{{1.0, 0.0}, 0.0};
    double least = infinity;
    for (std::size_t i = first_arc_[index]; i < first_arc_[index + 1]; ++i) {
        const ProfileArc& arc = arcs_[i];
        if (arc.kind == ProfileArc::Kind::gap) continue;
        const double s = arc.way(p), on_arc = glm::clamp(s, 0.0, arc.length);
        double v = 0.0;
        const auto [rise, slope] = arc.rise_at(on_arc, v);
        const double beside = arc.height(p) - (rise + slope * (s - on_arc));
        const double far = glm::abs(beside) + glm::abs(s - on_arc);
        if (far >= least) continue;
        least = far;
        // `outward` says which side of the piece's own direction is out.
        const bool is_right = arc.normal.x * arc.chord.y - arc.normal.y * arc.chord.x > 0.0;
        const double side = pieces_[index].outward * (is_right ? 1.0 : -1.0);
        const double per_length = side / glm::sqrt(1.0 + slope * slope);
        best = {per_length * (arc.normal - slope * arc.chord), per_length * beside};
        if (far <= 8.0 * unit_roundoff * magnitude()) break;
    }
    return best;
}

void Profile::find_outward_side(ProfilePiece& piece) const {
    piece.outward = 1.0;
    // The last ones are for what is thinner than a hair.
    for (const double step : {1e-7, 1e-5, 1e-3, 1e-9, 1e-11, 1e-13, 1e-15, 1e-17}) {
        for (const double u : {0.5, 0.3, 0.7, 0.1, 0.9}) {
            const Vec2 along = piece.tangent(u);
            const double length = glm::length(along);
            if (!(length > 0.0)) continue;
            const Vec2 p = piece.at(u), n = step * size_ / length * Vec2{along.y, -along.x};
            const bool inside_right = contains(p + n), inside_left = contains(p - n);
            if (inside_right == inside_left) continue;
            if (inside_right) piece.outward = -1.0;
            return;
        }
    }
}

}  // namespace meniscus::geom
