#include "geom/lathe_roots.hpp"

#include <utility>

namespace meniscus::geom {

namespace {

/// Where a line is at the height of a joint, or nearest to the axis.
struct Station {
    double t, radius2;
    bool inside;  // nearer to the axis than the profile
};

/// The line's distance from an arc, measured across its chord: it is positive on the side away from
/// the axis, and as exact as the coordinates.
struct Gap {
    double t, value, slope;
    double radius, radius_slope;
};

/// Looks for the crossings of a line with one arc.
class ArcSearch {
public:
    ArcSearch(const LatheLine& line, const ProfileArc& arc, double magnitude, LatheRoots& out)
        : line_(line),
          arc_(arc),
          precision_(unit_roundoff * magnitude),
          near_axis_(line.dd > 0.0 ? 1e-6 * magnitude : -1.0),
          out_(out) {}

    /// Between two joints, each at its height; the first comes first along the line.
    void between(const Station& a, const Station& b) {
        if (!(a.t < line_.nearest && line_.nearest < b.t)) {
            return approaching_or_receding(a, b, a.t < line_.nearest);
        }
        Station turn{line_.nearest, line_.closest2, false};
        if (turn.radius2 < arc_.outer2) {
            turn.inside = turn.radius2 < arc_.inner2 || gap(turn.t).value < 0.0;
        }
        approaching_or_receding(a, turn, true);
        approaching_or_receding(turn, b, false);
    }

private:
    /// On one side of the point nearest to the axis: radius and height of the line's path each only
    /// rise or only fall, as those of the arc do.
    void approaching_or_receding(const Station& a, const Station& b, bool approaching) {
        approaching_ = approaching;
        const double across = arc_.normal.y * line_.ray.along_d * (approaching ? -1.0 : 1.0);
        // Against each other they cross once at most.
        const bool against = arc_.normal.x == 0.0 || across >= 0.0;
        const bool hollow = arc_.kind == ProfileArc::Kind::hollow;
        if (a.inside == b.inside) {
            if (against) return;
            const auto& [near, far] = approaching ? std::pair{b, a} : std::pair{a, b};
            if (a.inside ? !hollow || far.radius2 <= arc_.inner2 : near.radius2 >= arc_.outer2) {
                return;
            }
        }
        const auto [low, high] = within_radii(a, b, approaching);
        const Gap chord_low = chord_gap(low), chord_high = chord_gap(high);
        if (a.inside != b.inside) {
            if (against || !hollow || is_steady(chord_low, chord_high)) {
                const double part = chord_low.value / (chord_low.value - chord_high.value);
                // Not at an end, which a grazing line may come back to.
                const double within = part > 0.0 && part < 1.0 ? glm::clamp(part, 0.1, 0.9) : 0.5;
                return cross(low, high, a.inside, low + within * (high - low));
            }
        } else if (a.inside) {
            // Over the chord the gap is convex: between its greatest value at an end and its
            // tangents.
            if (glm::max(chord_low.value, chord_high.value) < arc_.least_rise) return;
        } else {
            if (least(chord_low, chord_high) > arc_.greatest_rise) return;
        }
        search(gap(low), gap(high), a.inside, b.inside, 50);
    }

    /// Whether the gap only rises or only falls, seen from its chord: the slope over the chord only
    /// grows, and the arc changes it by no more than its own slope.
    bool is_steady(const Gap& low, const Gap& high) const {
        const double most = glm::max(glm::abs(arc_.slope_start), glm::abs(arc_.slope_end)) *
                            glm::max(glm::abs(pace(low)), glm::abs(pace(high)));
        return low.slope > most || high.slope < -most;
    }

    /// How fast the line goes along the chord.
    double pace(const Gap& g) const {
        return arc_.chord.x * g.radius_slope + arc_.chord.y * line_.ray.along_d;
    }

    /// A lower bound of a convex function between two places: it lies above its tangents.
    static double least(const Gap& a, const Gap& b) {
        if (a.slope >= 0.0) return a.value;
        if (b.slope <= 0.0) return b.value;
        const double way = (b.value - a.value - b.slope * (b.t - a.t)) / (a.slope - b.slope);
        return a.value + a.slope * way;
    }

    /// The part of the path whose radius the arc reaches.
    std::pair<double, double> within_radii(const Station& a, const Station& b,
                                           bool approaching) const {
        const auto at_radius = [&](double radius2) {
            const double way = glm::sqrt(glm::max(radius2 - line_.closest2, 0.0) / line_.dd);
            return line_.nearest + (approaching ? -way : way);
        };
        double low = a.t, high = b.t;
        double& far = approaching ? low : high;
        double& near = approaching ? high : low;
        constexpr double slack = 1e-12;
        if ((approaching ? a : b).radius2 > arc_.outer2)
            far = at_radius(arc_.outer2 * (1.0 + slack));
        if ((approaching ? b : a).radius2 < arc_.inner2)
            near = at_radius(arc_.inner2 * (1.0 - slack));
        return {glm::max(low, a.t), glm::min(high, b.t)};
    }

    /// The line's distance from the chord.
    Gap chord_gap(double t) const {
        const AxialRay& ray = line_.ray;
        const double x = ray.across_e.x + t * ray.across_d.x;
        const double z = ray.across_e.z + t * ray.across_d.z;
        double radius = glm::sqrt(x * x + z * z);
        double outwards = radius > 0.0 ? (x * ray.across_d.x + z * ray.across_d.z) / radius : 0.0;
        if (radius < near_axis_) {
            // x and z have lost their digits: as seen from the point nearest to the axis.
            const double way = t - line_.nearest;
            radius = glm::sqrt(line_.closest2 + line_.dd * way * way);
            outwards = radius > 0.0 ? line_.dd * way / radius
                                    : glm::sqrt(line_.dd) * (approaching_ ? -1.0 : 1.0);
        }
        return {t, arc_.height({radius, line_.height(t)}),
                arc_.normal.x * outwards + arc_.normal.y * ray.along_d, radius, outwards};
    }

    Gap gap(double t) {
        Gap result = chord_gap(t);
        if (arc_.kind == ProfileArc::Kind::straight) return result;
        const double way = arc_.way({result.radius, line_.height(t)});
        const auto rise = arc_.rise_at(way, v_);
        result.value -= rise.value;
        result.slope -=
            rise.slope * (arc_.chord.x * result.radius_slope + arc_.chord.y * line_.ray.along_d);
        return result;
    }

    /// The one crossing between two places on different sides of the arc: Newton's method, halving
    /// where a step would leave the bracket.
    void cross(double low, double high, bool rising) {
        cross(low, high, rising, 0.5 * (low + high));
    }
    void cross(double low, double high, bool rising, double t) {
        for (int i = 0; i < 100 && low < high; ++i) {
            const Gap here = gap(t);
            const bool is_here = glm::abs(here.value) <= 0.5 * precision_;
            if (is_here && (here.slope > 0.0) == rising) break;
            ((here.value < 0.0) == rising ? low : high) = t;
            double next = t - here.value / here.slope;
            const bool is_newton = next > low && next < high;
            if (!is_newton) next = 0.5 * (low + high);
            const double step = glm::abs(next - t);
            t = next;
            if (step <= precision_ || (is_newton && misses_by_little(here, step))) break;
        }
        out_.push_back({t, arc_.piece});
    }

    /// Whether the gap's second derivative leaves nothing after a step of Newton's method.
    bool misses_by_little(const Gap& from, double step) const {
        if (!(step < 0.1 * from.radius)) return false;
        const double bend = 2.0 * widening(from) + arc_.greatest_bend;
        return bend * step * step <= precision_;
    }

    /// The second derivative of the line's distance from the axis.
    double widening(const Gap& g) const {
        return line_.closest2 * line_.dd / (g.radius * g.radius * g.radius);
    }

    struct Range {
        double low, high;
    };

    /// Bounds of the gap's second derivative: n.x radius'' - rise'' way'^2, with n the normal where
    /// the line is.
    Range bend(const Gap& a, const Gap& b) const {
        if (arc_.kind != ProfileArc::Kind::hollow) return {0.0, infinity};
        const auto lean = [&](double slope) { return arc_.normal.x - slope * arc_.chord.x; };
        const auto [least_widening, most_widening] = std::minmax({widening(a), widening(b)});
        const auto [least_lean, most_lean] =
            std::minmax({lean(arc_.slope_start), lean(arc_.slope_end)});
        const double speed_a = pace(a), speed_b = pace(b);
        const auto [slow2, fast2] = std::minmax({speed_a * speed_a, speed_b * speed_b});
        const double slowest2 = speed_a * speed_b > 0.0 ? slow2 : 0.0;
        return {glm::max(least_lean, 0.0) * least_widening - arc_.greatest_bend * fast2,
                most_lean * most_widening - arc_.least_bend * slowest2};
    }

    /// All crossings between two places, of which it is known on which sides of the arc they are.
    void search(const Gap& a, const Gap& b, bool inside_a, bool inside_b, int splits) {
        const double width = b.t - a.t;
        const Range bend = this->bend(a, b);
        const bool bends_one_way = bend.low >= 0.0 || bend.high <= 0.0;
        const bool is_last = splits == 0 || !(width > precision_);
        if (inside_a != inside_b) {
            const bool only_rises = a.slope + glm::min(bend.low, 0.0) * width > 0.0;
            const bool only_falls = a.slope + glm::max(bend.high, 0.0) * width < 0.0;
            if (bends_one_way || only_rises || only_falls || is_last) {
                return cross(a.t, b.t, inside_a);
            }
        } else {
            // Seen from the side where both ends are, only a dip crosses.
            const double dip = inside_a ? -bend.low : bend.high;
            if (is_last || dip <= 0.0) return;
            const double least =
                inside_a ? -glm::max(a.value, b.value) : glm::min(a.value, b.value);
            if (least > 0.125 * dip * width * width) return;
            if (bends_one_way) return cross_dip(a, b, inside_a);
        }
        const Gap middle = gap(a.t + 0.5 * width);
        const bool inside = middle.value < 0.0;
        search(a, middle, inside_a, inside, splits - 1);
        search(middle, b, inside, inside_b, splits - 1);
    }

    /// The gap lies on one side at both ends and is bent towards the other all the way: it has one
    /// extreme, and crosses twice if that is on the other side. It lies beyond its tangents, so
    /// most are seen not to before the extreme is found.
    void cross_dip(Gap a, Gap b, bool inside) {
        const double sign = inside ? -1.0 : 1.0;
        for (int i = 0; i < 60; ++i) {
            const double fall = sign * a.slope, rise = sign * b.slope, width = b.t - a.t;
            if (!(fall < 0.0 && rise > 0.0) || !(width > 0.0)) return;
            // Where the tangents meet
            const double x = (sign * (b.value - a.value) - rise * width) / (fall - rise);
            if (sign * a.value + fall * x > 0.0) return;
            // Where the slope would be 0 if it changed evenly; now and then the middle.
            const double part = i % 3 == 2 ? 0.5 : -fall / (rise - fall);
            const Gap middle = gap(a.t + part * width);
            if (sign * middle.value < 0.0) {
                cross(a.t, middle.t, inside);
                cross(middle.t, b.t, !inside);
                return;
            }
            if (!(middle.t > a.t && middle.t < b.t)) return;
            (sign * middle.slope < 0.0 ? a : b) = middle;
        }
    }

    const LatheLine& line_;
    const ProfileArc& arc_;
    double precision_;
    double near_axis_;
    bool approaching_ = false;
    LatheRoots& out_;
    double v_ = 0.0;  // of the arc, where it was asked last
};

/// Whether an arc that both of its joints leave on the same side may yet be crossed twice.
bool may_be_crossed_twice(const LatheLine& line, const ProfileArc& arc, const Station& a,
                          const Station& b) {
    if (a.inside) {
        return arc.kind == ProfileArc::Kind::hollow && glm::max(a.radius2, b.radius2) > arc.inner2;
    }
    if (line.closest2 >= arc.outer2) return false;
    const bool passes_nearest = (a.t < line.nearest) != (b.t < line.nearest);
    return passes_nearest || glm::min(a.radius2, b.radius2) < arc.outer2;
}

}  // namespace

void append_roots(const LatheLine& line, const Profile& profile, LatheRoots& out) {
    // A line across the axis is taken to rise by less than any number, from a hair above its
    // height.
    constexpr double far = 1e100;
    const bool level = glm::abs(line.ray.along_d) < 1.0 / far;
    const double per_height = level ? far : 1.0 / line.ray.along_d;
    const auto pass = [&](const Vec2& joint) {
        const double way = joint.y - line.ray.along_e;
        const double t = level && !(way > 0.0) ? -far : way * per_height;
        const double radius2 = line.radius2(t);
        return Station{t, radius2, radius2 < joint.x * joint.x};
    };
    Station at_start{};
    bool has_start = false;
    for (const ProfileArc& arc : profile.arcs()) {
        if (arc.kind == ProfileArc::Kind::gap) {
            has_start = false;
            continue;
        }
        if (!has_start) at_start = pass(arc.start);
        const Station at_end = pass(arc.end);
        if (at_start.inside != at_end.inside || may_be_crossed_twice(line, arc, at_start, at_end)) {
            ArcSearch search(line, arc, profile.magnitude(), out);
            if (at_start.t <= at_end.t) {
                search.between(at_start, at_end);
            } else {
                search.between(at_end, at_start);
            }
        }
        at_start = at_end;
        has_start = true;
    }
}

}  // namespace meniscus::geom
