#pragma once

#include <optional>
#include <vector>

#include "tracer/offers.hpp"
#include "tracer/options.hpp"
#include "tracer/ray_state.hpp"

namespace meniscus::tracer {

/// One crossing as it was judged, for `inspect`.
struct Judged {
    double t;
    int part;
    bool entering;
    bool is_true;
};

/// Finds where a ray's medium changes next. One for each thread: it keeps scratch memory between
/// rays. What it does stands in a file each: one traversal of the scene (next_event.cpp), the way
/// along what that found (walk.cpp, make_event.cpp), the first list (start.cpp), the checks of its
/// own work (self_check.cpp), a short way for scenes without dielectrics (next_surface.cpp), and
/// the paper's method beside it (recast.cpp).
class EventFinder {
public:
    EventFinder(const RenderScene& scene, const Options& options, Statistics& statistics);

    /// The next event with t <= t_max, or nothing. Then `ray.interior` is the list at infinity (or
    /// at t_max).
    std::optional<Event> next(TracedRay& ray, double t_max = geom::infinity);

    /// A ray that starts at `origin` in the open, its list computed from which solids contain the
    /// origin.
    TracedRay start(const geom::Ray& ray, RayKind kind);

    const RenderScene& scene() const { return scene_; }
    Statistics& statistics() { return statistics_; }

    std::vector<Judged>* record =
        nullptr;  // where to note every crossing judged, if anyone wants to know

private:
    std::optional<Event> sweep(TracedRay& ray, double t_max);
    std::optional<Event> recast(TracedRay& ray, double t_max);
    std::optional<Event> next_surface(TracedRay& ray, double t_max);

    bool is_visible(const Part& part, RayKind kind) const;
    /// What a traversal goes no farther than.
    enum class Bound {
        true_crossings,  // entries above the top, and the exit from it
        entries,         // the former
        nothing
    };
    std::optional<Event> find_event(TracedRay& ray, double t_max);
    void collect(const TracedRay& ray, int top, double t_max, Bound by);
    void offer(const TracedRay& ray, int part, int top, Bound by);

    std::optional<Event> walk(TracedRay& ray);
    std::size_t find_pivot(const InteriorList& list, std::size_t begin) const;
    void gather_group(const TracedRay& ray, std::size_t begin, std::size_t pivot);
    void apply(const TracedRay& ray, const Offer& offer, InteriorList& list);
    void note(const Offer& offer, bool is_true);
    const Offer* surface_in_group() const;
    const Offer& owner_of_group(std::size_t pivot, int top_before, int top_after) const;
    Event make_group_event(const TracedRay& ray, std::size_t pivot, const Offer* surface,
                           const InteriorList& before, const InteriorList& after);

    Event make_event(const TracedRay& ray, double t, const Offer& owner, const InteriorList& before,
                     const InteriorList& after) const;
    double cosine(const TracedRay& ray, const Offer& offer) const;
    void check_segment(const TracedRay& ray, double t);
    std::optional<int> solid_at(const geom::Vec3& p, RayKind kind) const;
    bool may_be_at(const geom::Vec3& p, double rounding, int solid, RayKind kind) const;
    void check_medium(const TracedRay& ray, double t, double at);
    std::optional<Event> recover(TracedRay& ray, double t_max);
    void check_escape(const TracedRay& ray);

    const RenderScene& scene_;
    const Options& options_;
    Statistics& statistics_;
    Offers offers_;
    std::vector<Offer> found_;
    std::vector<char> used_;  // by index in found_: applied to the list, or in the group
    geom::InlineVector<std::uint32_t, 16> group_;  // coincident crossings: indices in found_
    std::vector<unsigned> visited_;  // by part: stamp of the traversal that saw it last
    unsigned stamp_ = 0;
    double bound_ = 0.0;  // this traversal looks no farther
    bool has_only_surfaces_;
};

}  // namespace meniscus::tracer
