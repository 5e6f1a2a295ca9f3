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

    /// Finds the next event with t <= t_max. False if there is none: then `ray.interior` is the
    /// list at infinity (or at t_max).
    bool next(TracedRay& ray, double t_max, Event& event);
    std::optional<Event> next(TracedRay& ray, double t_max = geom::infinity) {
        Event event;
        return next(ray, t_max, event) ? std::optional(std::move(event)) : std::nullopt;
    }

    /// A ray that starts at `origin` in the open, its list computed from which solids contain the
    /// origin.
    TracedRay start(const geom::Ray& ray, RayKind kind);
    /// Makes a ray one of another kind: what such rays do not see is in its list no more, and what
    /// the former did not see is, where it contains the origin.
    void become(TracedRay& ray, RayKind kind);

    const RenderScene& scene() const { return scene_; }
    Statistics& statistics() { return statistics_; }

    std::vector<Judged>* record =
        nullptr;  // where to note every crossing judged, if anyone wants to know

private:
    bool sweep(TracedRay& ray, double t_max, Event& event);
    bool recast(TracedRay& ray, double t_max, Event& event);
    bool next_surface(TracedRay& ray, double t_max, Event& event);

    bool is_visible(const Part& part, RayKind kind) const;
    /// What a traversal goes no farther than.
    enum class Bound {
        true_crossings,  // entries above the top, and the exit from it
        entries,         // the former
        nothing
    };
    bool find_event(TracedRay& ray, double t_max, Event& event);
    void collect(const TracedRay& ray, int top, double t_max, Bound by);
    void offer(const TracedRay& ray, int part, int top, Bound by);
    void sort_found();
    const Neighbours::Near* neighbours_of(int top) const;
    bool is_shut_in(const TracedRay& ray, int top) const;
    void ask_group(const TracedRay& ray, int group, int top, Bound by);
    bool misses_sphere(const TracedRay& ray, std::uint32_t primitive) const;

    int solid_of(int part) const { return part == outside ? outside : scene_.parts[part].solid; }
    /// Whether a crossing may change the solid that is there, `top` being on top of the list.
    bool may_be_true(const Offer& offer, int top) const;
    bool make_lone_event(const TracedRay& ray, int top, Event& event);
    bool walk(TracedRay& ray, Event& event);
    std::size_t find_pivot(const InteriorList& list, std::size_t begin) const;
    void gather_group(const TracedRay& ray, std::size_t begin, std::size_t pivot);
    void apply(const TracedRay& ray, const Offer& offer, InteriorList& list);
    void note(const Offer& offer, bool is_true);
    const Offer* surface_in_group() const;
    const Offer& owner_of_group(std::size_t pivot, int top_before, int top_after) const;
    void make_group_event(const TracedRay& ray, std::size_t pivot, const Offer* surface,
                          int top_before, int top_after, Event& event);

    void make_event(const TracedRay& ray, double t, const Offer& owner, int solid_before,
                    int solid_after, Event& event) const;
    double cosine(const TracedRay& ray, const Offer& offer) const;
    void check_segment(const TracedRay& ray, double t);
    std::optional<int> solid_at(const geom::Vec3& p, RayKind kind) const;
    bool may_be_at(const geom::Vec3& p, double rounding, int solid, RayKind kind) const;
    void check_medium(const TracedRay& ray, double t, double at);
    bool recover(TracedRay& ray, double t_max, Event& event);
    void check_escape(const TracedRay& ray);

    const RenderScene& scene_;
    const Options& options_;
    Statistics& statistics_;
    Offers offers_;
    std::vector<Offer> found_;
    std::vector<char> used_;  // by index in found_: applied to the list, or in the group
    geom::InlineVector<std::uint32_t, 16> group_;  // coincident crossings: indices in found_
    geom::InlineVector<int, 16> waiting_;  // parts crossed behind the pivot, but not with it
    std::vector<unsigned> visited_;        // by part: stamp of the traversal that saw it last
    unsigned stamp_ = 0;
    double bound_ = 0.0;       // this traversal looks no farther
    double bounding_t_ = 0.0;  // of the crossing that says so
    bool has_only_surfaces_;
    bool only_opaque_shades_;
};

}  // namespace meniscus::tracer
