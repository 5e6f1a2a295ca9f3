#pragma once

#include <algorithm>
#include <vector>

#include "tracer/ray_state.hpp"
#include "tracer/statistics.hpp"

namespace meniscus::tracer {

/// The contact tolerance: two crossings nearer than this, measured along the normal, are one.
/// `magnitude` is M = largest coordinate of the origin + t + largest coordinate of the solid, the
/// scale of all rounding errors at the crossing (docs/numerics.md).
inline double tolerance(const RenderScene& scene, double magnitude) {
    return std::max(scene.tolerance_units * geom::unit_roundoff * magnitude,
                    scene.contact_tolerance);
}

/// Crossings up to here may coincide along the normal with one at `t`, at grazing angles.
inline double reach(const RenderScene& scene, double t, double magnitude) {
    return t + std::max(1e-7 * magnitude, 100.0 * scene.contact_tolerance);
}

/// One crossing that a part offers to a ray, at t >= 0.
struct Offer {
    double t;
    int part;
    geom::Face face;
    bool entering;  // the solid: for an inverse part this is leaving the shape
};

/// Which crossings of a part end the segment, wherever they are: what lies behind the nearest of
/// them is not needed.
struct Decisive {
    bool entering, leaving;  // the solid
};

/// What a part offers to a ray whose list is known. No epsilon anywhere: a solid in the list can
/// only be left, one that is not in it only be entered, and what lies behind the origin by rounding
/// is taken to lie on it.
class Offers {
public:
    Offers(const RenderScene& scene, Statistics& statistics)
        : scene_(scene), statistics_(statistics) {}

    /// Appends the crossings of `part` in [0, t_max], each with t clamped to 0 or more.
    void collect(const TracedRay& ray, int part, double t_max, Decisive decisive,
                 std::vector<Offer>& out);

    /// M of a crossing of `part` at `t`.
    double magnitude(const TracedRay& ray, int part, double t) const {
        return geom::max_abs(ray.ray.origin) + t + scene_.parts[part].shape.magnitude();
    }
    /// The anchor that the face crossed has, if any, and M of a crossing from there.
    int anchor_of(const Offer& offer) const;
    double magnitude_from(int anchor, const TracedRay& ray, double t) const;
    /// M of two crossings that are compared: from the anchor that they share, if they do.
    double magnitude(const TracedRay& ray, const Offer& a, const Offer& b) const;

private:
    void collect_convex(const TracedRay& ray, const Part& part, int index, const Contact* contact,
                        double t_max, std::vector<Offer>& out);
    void collect_general(const TracedRay& ray, const Part& part, int index, const Contact* contact,
                         double t_max, std::vector<Offer>& out);
    bool collect_ahead(const TracedRay& ray, const Part& part, int index, const Contact* contact,
                       double t_max, Decisive decisive, std::vector<Offer>& out);
    void collect_open(const TracedRay& ray, const Part& part, int index, const Contact* contact,
                      double t_max, Decisive decisive, std::vector<Offer>& out);
    geom::Search search(const TracedRay& ray, const Part& part, double t_max,
                        Decisive decisive) const;
    double cosine(const TracedRay& ray, const Part& part, geom::Face face, double t) const;
    double start_magnitude(const TracedRay& ray, const Part& part) const;
    double rounded_magnitude(const TracedRay& ray, const Part& part) const;
    bool is_rounding(const TracedRay& ray, const Part& part, double distance) const;
    bool is_far_outside(const TracedRay& ray, const Part& part) const;
    bool holds_origin(const TracedRay& ray, const Part& part, const geom::Interval& interval) const;
    bool is_at_surface(const TracedRay& ray, const Part& part, int depth, int other) const;
    void count_forced(const TracedRay& ray, const Part& part, double disagreement);

    const RenderScene& scene_;
    Statistics& statistics_;
    geom::Crossings crossings_;
};

}  // namespace meniscus::tracer
