// How far it is to the next two crossings with a lathe of straight pieces, in lanes.

#if defined(MENISCUS_LANES_NEAR_LATHE) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_NEAR_LATHE
#undef MENISCUS_LANES_NEAR_LATHE
#else
#define MENISCUS_LANES_NEAR_LATHE
#endif

#include "lanes/spans-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

/// The nearest crossings ahead at which rays enter and leave.
struct NextCrossings {
    F enter, leave, enter_face, leave_face;
    M odd;  // whether their number ahead is odd: such rays start inside
    M doubt;
};

/// Gathers the crossings of one lathe, in any order. A line takes turns in entering and leaving, so
/// the nearest of each kind are the next two.
class CrossingSearch {
public:
    HWY_INLINE CrossingSearch()
        : enter_(infinity),
          leave_(infinity),
          enter_face_(0.0),
          leave_face_(0.0),
          closest_(infinity),
          odd_(no_lanes()) {}

    HWY_INLINE M count(M ahead) {
        odd_ = odd_ ^ ahead;
        return ahead;
    }
    HWY_INLINE void enter(F t, double face, M which) { put(enter_, enter_face_, t, face, which); }
    HWY_INLINE void leave(F t, double face, M which) { put(leave_, leave_face_, t, face, which); }
    /// What decides must not be next to 0. (In this order for numbers that are none.)
    HWY_INLINE void decide(F room) { closest_ = min(abs(room), closest_); }

    HWY_INLINE NextCrossings found(F slack) const {
        NextCrossings result;
        result.enter = enter_;
        result.leave = leave_;
        result.enter_face = enter_face_;
        result.leave_face = leave_face_;
        result.odd = odd_;
        result.doubt = (closest_ < slack) | (abs(enter_ - leave_) < slack);
        return result;
    }

private:
    static HWY_INLINE void put(F& nearest, F& nearest_face, F t, double face, M which) {
        const M sooner = which & (t < nearest);
        nearest = select(sooner, t, nearest);
        nearest_face = select(sooner, F(face), nearest_face);
    }

    F enter_, leave_, enter_face_, leave_face_, closest_;
    M odd_;
};

/// Rays seen by a lathe, from the point of each that is nearest to its middle: `shift` is the way
/// there. The formulas are those of `lathe_stretches`.
struct LatheLine {
    F3 d;
    F length, shift, start, height, dd, per_dd, b, ff, per_dy, steepness;
    M upwards;

    HWY_INLINE LatheLine(const Program& program, const Solid& solid, const Rays& rays)
        : length(1.0) {
        Line scratch;
        const Line& ray = local(solid, rays, scratch);
        d = ray.direction;
        // Crossings so near to the start are where the ray was born.
        start = max(F(program.tolerance_units * unit_roundoff) * (rays.birth + F(solid.magnitude)),
                    F(program.contact_tolerance));
        if (solid.placed) {
            length = sqrt(ray.squared_length);
            d = (F(1.0) / length) * d;
            // Of lengths in the solid's frame; what rounding makes of them is nothing to it.
            start = F(1.0 + 1e-12) * (start * length);
        }
        const F3 from_middle = ray.origin - F3(geom::Vec3{0.0, solid.height, 0.0});
        shift = -dot(from_middle, d);
        const F3 e = from_middle + shift * d;
        height = e.y + F(solid.height);
        dd = d.x * d.x + d.z * d.z;
        per_dd = F(1.0) / dd;
        b = (e.x * d.x + e.z * d.z) * per_dd;
        const F fx = e.x - b * d.x, fz = e.z - b * d.z;
        ff = fx * fx + fz * fz;
        per_dy = F(1.0) / d.y;
        steepness = abs(d.y);
        upwards = F(0.0) < d.y;
    }

    HWY_INLINE F way_to(double y) const { return (F(y) - height) * per_dy; }
    HWY_INLINE F height_at(F t) const { return height + t * d.y; }
    /// Whether a crossing of slope `slope`, without its sign, lies ahead.
    HWY_INLINE M is_ahead(F t, F slope) const { return start < (t + shift) * slope; }
    /// From the rays' origins, in the world.
    HWY_INLINE F from_origin(const Solid& solid, F t) const {
        return solid.placed ? (t + shift) / length : t + shift;
    }
};

/// The two crossings with a cylinder about a lathe's axis, however long.
struct SideCrossings {
    F room, low, high, slope;

    HWY_INLINE SideCrossings(const LatheLine& line, double radius)
        : room(F(radius * radius) - line.ff) {
        const F half = sqrt(max(room * line.per_dd, F(0.0)));
        low = -half - line.b;
        high = half - line.b;
        slope = (half * line.dd) * F(1.0 / radius);
    }
};

/// The next crossings with a lathe of rings and cylinders about its y axis; slack and margins are
/// those of `lathe_stretches`.
HWY_INLINE NextCrossings next_crossings(const Program& program, const Solid& solid,
                                        const Rays& rays) {
    const LatheLine line(program, solid, rays);
    // Rooms are measured so that one slack serves for all.
    const double slack = 1e-9 * solid.size;
    CrossingSearch search;
    for (std::size_t i = 0; i < solid.pieces.size(); ++i) {
        const Piece& piece = solid.pieces[i];
        if (piece.high_radius == 0.0) continue;  // along the axis
        const double face = double(i);
        if (piece.a == 0.0) {  // a ring
            const F t = line.way_to(piece.low_height);
            const F from_nearest = t + line.b;
            const F radius2 = line.ff + line.dd * (from_nearest * from_nearest);
            const F scale(0.5 / piece.high_radius);
            const F outer = scale * (F(piece.high_radius * piece.high_radius) - radius2);
            search.decide(outer);
            M valid = F(0.0) < outer;
            if (piece.low_radius > 0.0) {
                const F inner = scale * (F(piece.low_radius * piece.low_radius) - radius2);
                search.decide(inner);
                valid = but_not(valid, F(0.0) < inner);
            }
            const M ahead = search.count(valid & line.is_ahead(t, line.steepness));
            const M enters = piece.b > 0.0 ? but_not(ahead, line.upwards) : ahead & line.upwards;
            search.enter(t, face, enters);
            search.leave(t, face, but_not(ahead, enters));
        } else {  // a cylinder
            const SideCrossings side(line, piece.high_radius);
            // A narrow miss is one by a share of the lathe's size.
            search.decide(F(1.0 / solid.size) * side.room);
            const M meets = F(0.0) < side.room;
            const F middle(0.5 * (piece.low_height + piece.high_height)),
                reach(0.5 * (piece.high_height - piece.low_height));
            for (const bool far : {false, true}) {
                const F t = far ? side.high : side.low;
                const F room = reach - abs(line.height_at(t) - middle);
                search.decide(room);
                const M ahead =
                    search.count(meets & (F(0.0) < room) & line.is_ahead(t, side.slope));
                if (far == (piece.a > 0.0)) {
                    search.leave(t, face, ahead);
                } else {
                    search.enter(t, face, ahead);
                }
            }
        }
    }
    NextCrossings next = search.found(F(slack));
    next.doubt = next.doubt | (line.dd < F(1e-12));
    next.enter = line.from_origin(solid, next.enter);
    next.leave = line.from_origin(solid, next.leave);
    return next;
}

/// The same for a cup, which is one cylinder without another: [a0, a1] without [b0, b1].
HWY_INLINE NextCrossings next_of_cup(const Program& program, const Solid& solid, const Rays& rays) {
    const LatheLine line(program, solid, rays);
    const Cup& cup = solid.cup;
    const SideCrossings outer(line, cup.outer_radius), inner(line, cup.inner_radius);
    const F to_base = line.way_to(cup.base), to_floor = line.way_to(cup.floor),
            to_top = line.way_to(cup.top);
    const auto nearer = [&](F lower, F upper)
                            HWY_ATTR { return select(line.upwards, lower, upper); };
    const F near_a = nearer(to_base, to_top), far_a = nearer(to_top, to_base),
            near_b = nearer(to_floor, to_top), far_b = nearer(to_top, to_floor);
    const F a0 = max(near_a, outer.low), a1 = min(far_a, outer.high), b0 = max(near_b, inner.low),
            b1 = min(far_b, inner.high);

    // What decides must not be next to 0: whether a side is met, and above or below which edge.
    F closest = F(1.0 / solid.size) * min(abs(outer.room), abs(inner.room));
    const auto keep_off = [&](F t, double low, double high) HWY_ATTR {
        const F room = F(0.5 * (high - low)) - abs(line.height_at(t) - F(0.5 * (low + high)));
        closest = min(abs(room), closest);
    };
    keep_off(outer.low, cup.base, cup.top);
    keep_off(outer.high, cup.base, cup.top);
    keep_off(inner.low, cup.floor, cup.top);
    keep_off(inner.high, cup.floor, cup.top);

    const M is_a = (F(0.0) < outer.room) & (a0 < a1);
    const M is_b = is_a & (F(0.0) < inner.room) & (b0 < b1);
    const M flat_a0 = outer.low <= near_a, flat_a1 = far_a <= outer.high,
            flat_b0 = inner.low <= near_b, flat_b1 = far_b <= inner.high;
    const auto ahead = [&](F t, M flat, const SideCrossings& side) HWY_ATTR {
        return line.is_ahead(t, select(flat, line.steepness, side.slope));
    };
    // Where the inner one begins or ends as the outer one does, the cup is open.
    const M open_in = is_b & (b0 <= a0), open_out = is_b & (a1 <= b1);
    const M enters_a = but_not(is_a, open_in) & ahead(a0, flat_a0, outer),
            leaves_a = but_not(is_a, open_out) & ahead(a1, flat_a1, outer),
            leaves_b = but_not(is_b, open_in) & ahead(b0, flat_b0, inner),
            enters_b = but_not(is_b, open_out) & ahead(b1, flat_b1, inner);
    const F base(cup.base_face), top(cup.top_face), floor(cup.floor_face),
        outer_side(cup.outer_face), inner_side(cup.inner_face);
    NextCrossings next;
    next.enter = select(enters_a, a0, select(enters_b, b1, F(infinity)));
    next.leave = select(leaves_b, b0, select(leaves_a, a1, F(infinity)));
    next.enter_face = select(enters_a, select(flat_a0, nearer(base, top), outer_side),
                             select(flat_b1, floor, inner_side));
    next.leave_face = select(leaves_b, select(flat_b0, floor, inner_side),
                             select(flat_a1, nearer(top, base), outer_side));
    next.odd = enters_a ^ leaves_a ^ enters_b ^ leaves_b;
    const F slack(1e-9 * solid.size);
    next.doubt = (closest < slack) | (abs(next.enter - next.leave) < slack) | (line.dd < F(1e-12)) |
                 (line.d.y == F(0.0));
    next.enter = line.from_origin(solid, next.enter);
    next.leave = line.from_origin(solid, next.leave);
    return next;
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
