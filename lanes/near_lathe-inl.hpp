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
    HWY_INLINE CrossingSearch(F shift, F start)
        : enter_(infinity),
          leave_(infinity),
          enter_face_(0.0),
          leave_face_(0.0),
          closest_(infinity),
          shift_(shift),
          start_(start),
          odd_(no_lanes()),
          doubt_(odd_) {}

    /// A crossing at `t` from the middle, of slope `slope` without its sign, where `room` is above
    /// 0; within `slack` of that it is not sure.
    HWY_INLINE M ahead(F t, F slope, M valid) {
        const M result = valid & (start_ < (t + shift_) * slope);
        odd_ = odd_ ^ result;
        return result;
    }
    HWY_INLINE void enter(F t, double face, M which) { put(enter_, enter_face_, t, face, which); }
    HWY_INLINE void leave(F t, double face, M which) { put(leave_, leave_face_, t, face, which); }
    /// What decides must not be next to 0. (In this order for numbers that are none.)
    HWY_INLINE void decide(F room) { closest_ = min(abs(room), closest_); }
    HWY_INLINE void doubt(M which) { doubt_ = doubt_ | which; }

    HWY_INLINE NextCrossings found(F slack) const {
        NextCrossings result;
        result.enter = enter_;
        result.leave = leave_;
        result.enter_face = enter_face_;
        result.leave_face = leave_face_;
        result.odd = odd_;
        result.doubt = doubt_ | (closest_ < slack) | (abs(enter_ - leave_) < slack);
        return result;
    }

private:
    static HWY_INLINE void put(F& nearest, F& nearest_face, F t, double face, M which) {
        const M sooner = which & (t < nearest);
        nearest = select(sooner, t, nearest);
        nearest_face = select(sooner, F(face), nearest_face);
    }

    F enter_, leave_, enter_face_, leave_face_, closest_, shift_, start_;
    M odd_, doubt_;
};

/// The next crossings with a lathe of rings and cylinders about its y axis; `slack` and the margins
/// are those of `lathe_stretches`, whose formulas these are.
HWY_INLINE NextCrossings next_crossings(const Program& program, const Solid& solid,
                                        const Rays& rays) {
    Line scratch;
    const Line& ray = local(solid, rays, scratch);
    F3 d = ray.direction;
    F length(1.0);
    F start = max(F(program.tolerance_units * unit_roundoff) * (rays.birth + F(solid.magnitude)),
                  F(program.contact_tolerance));
    if (solid.placed) {
        length = sqrt(ray.squared_length);
        d = (F(1.0) / length) * d;
        // Of lengths in the solid's frame; what rounding makes of them is nothing to it.
        start = F(1.0 + 1e-12) * (start * length);
    }
    const F3 from_middle = ray.origin - F3(geom::Vec3{0.0, solid.height, 0.0});
    const F shift = -dot(from_middle, d);
    const F3 e = from_middle + shift * d;
    const F height = e.y + F(solid.height);
    const F dd = d.x * d.x + d.z * d.z, ed = e.x * d.x + e.z * d.z;
    const F per_dd = F(1.0) / dd;
    const F b = ed * per_dd;
    const F fx = e.x - b * d.x, fz = e.z - b * d.z;
    const F ff = fx * fx + fz * fz;
    const F per_dy = F(1.0) / d.y;
    const F steepness = abs(d.y);
    const M upwards = F(0.0) < d.y;

    // Rooms are measured so that one slack serves for all.
    const double slack = 1e-9 * solid.size;
    CrossingSearch search(shift, start);
    for (std::size_t i = 0; i < solid.pieces.size(); ++i) {
        const Piece& piece = solid.pieces[i];
        const double face = double(i);
        if (piece.a == 0.0) {  // a ring
            const F t = (F(piece.low_height) - height) * per_dy;
            const F from_nearest = t + b;
            const F radius2 = ff + dd * (from_nearest * from_nearest);
            const F scale(0.5 / piece.high_radius);
            const F outer = scale * (F(piece.high_radius * piece.high_radius) - radius2);
            search.decide(outer);
            M valid = F(0.0) < outer;
            if (piece.low_radius > 0.0) {
                const F inner = scale * (F(piece.low_radius * piece.low_radius) - radius2);
                search.decide(inner);
                valid = but_not(valid, F(0.0) < inner);
            }
            const M ahead = search.ahead(t, steepness, valid);
            const M enters = piece.b > 0.0 ? but_not(ahead, upwards) : ahead & upwards;
            search.enter(t, face, enters);
            search.leave(t, face, but_not(ahead, enters));
        } else {  // a cylinder
            const double radius = piece.high_radius;
            const F room = F(radius * radius) - ff;
            // A narrow miss is one by a share of the lathe's size.
            search.decide(F(1.0 / solid.size) * room);
            const M meets = F(0.0) < room;
            const F half = sqrt(max(room * per_dd, F(0.0)));
            const F slope = (half * dd) * F(1.0 / radius);
            const F middle(0.5 * (piece.low_height + piece.high_height)),
                reach(0.5 * (piece.high_height - piece.low_height));
            for (const bool far : {false, true}) {
                const F t = far ? half - b : -half - b;
                const F room_y = reach - abs((height + t * d.y) - middle);
                search.decide(room_y);
                const M ahead = search.ahead(t, slope, meets & (F(0.0) < room_y));
                if (far == (piece.a > 0.0)) {
                    search.leave(t, face, ahead);
                } else {
                    search.enter(t, face, ahead);
                }
            }
        }
    }
    NextCrossings next = search.found(F(slack));
    next.doubt = next.doubt | (dd < F(1e-12));
    next.enter = next.enter + shift;
    next.leave = next.leave + shift;
    if (solid.placed) {
        next.enter = next.enter / length;
        next.leave = next.leave / length;
    }
    return next;
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
