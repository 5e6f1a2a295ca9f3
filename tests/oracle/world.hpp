#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "scene/scene.hpp"
#include "tests/oracle/body.hpp"

namespace meniscus::oracle {

inline constexpr int nothing = -1;

/// Where a ray's segment ends: at a surface between two media, or at an opaque one.
template <class Real>
struct Surface {
    Real t{0};
    int before = nothing,
        after = nothing;  // solids whose media meet here; `nothing` is the outside
    int skin = nothing;   // the object whose texture is seen
    bool opaque = false;
    Vector<Real> normal;  // unit length, faces the ray
};

/// A scene as the oracle sees it. It keeps no list of what a ray is in: all meetings of the ray's
/// line with all surfaces are sorted, and in the middle of each interval between them every solid
/// is asked whether it contains that point.
template <class Real>
class World {
public:
    using V = Vector<Real>;

    /// Surfaces nearer than `contact`, along their normals, are in contact. It must be far larger
    /// than the rounding of the scene's numbers, and far smaller than its features.
    explicit World(const scene::Scene& scene, double contact = 3e-14)
        : scene_(scene), contact_(contact), nearby_(3e9 * contact) {
        for (const scene::Object& object : scene.objects) bodies_.emplace_back(object);
        const std::size_t solids = scene.solids.size();
        parts_.resize(solids);
        is_medium_.assign(solids, false);
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
            const std::size_t solid = scene.objects[i].solid;
            parts_[solid].push_back(int(i));
            const scene::Interior& interior = scene.solids[solid].interior;
            const bool is_medium = interior.states_ior || interior.states_priority ||
                                   interior.attenuates() || lets_through(int(i));
            is_medium_[solid] = is_medium_[solid] || is_medium;
        }
        for (std::size_t i = 0; i < solids; ++i) {
            if (is_medium_[i]) by_priority_.push_back(int(i));
        }
        std::stable_sort(by_priority_.begin(), by_priority_.end(),
                         [&](int a, int b) { return priority(a) > priority(b); });
    }

    const scene::Scene& scene() const { return scene_; }
    const Body<Real>& body(int object) const { return bodies_[object]; }
    const scene::Interior& medium(int solid) const {
        return solid == nothing ? scene_.settings.outside : scene_.solids[solid].interior;
    }

    /// What fills the space at p: the solid of highest priority that contains it.
    int solid_at(const V& p) const {
        for (const int solid : by_priority_) {
            if (solid_contains(solid, p)) return solid;
        }
        return nothing;
    }

    /// The first surface on o + t d with t in (0, limit). The origin may lie on surfaces: those are
    /// not met again. `start` is the solid that the ray begins in.
    std::optional<Surface<Real>> next(const V& o, const V& d, int& start,
                                      Real limit = Real(1e300)) const {
        std::vector<Meeting> meetings;
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            bodies_[i].meet(o, d, [&](Real t, int face) {
                if (t > -nearby_ && t < limit) meetings.push_back({t, int(i), face});
            });
        }
        std::sort(meetings.begin(), meetings.end(),
                  [](const Meeting& a, const Meeting& b) { return a.t < b.t; });
        // Those at the origin: behind it, or as near to it as rounding may put them.
        std::size_t first = 0;
        for (std::size_t i = 0; i < meetings.size() && meetings[i].t < nearby_; ++i) {
            if (meetings[i].t <= 0 || meetings[i].t * cosine(o, d, meetings[i]) <= 4 * contact_)
                first = i + 1;
        }
        meetings.erase(meetings.begin(), meetings.begin() + std::ptrdiff_t(first));

        const auto middle = [&](Real from, std::size_t next_meeting) {
            const Real open = from + 1 + absolute(from);
            const Real to = next_meeting < meetings.size() ? meetings[next_meeting].t
                            : limit < open                 ? limit
                                                           : open;
            return o + ((from + to) / 2) * d;
        };
        V sample_before = middle(Real(0), 0);
        int before = solid_at(sample_before);
        start = before;
        for (std::size_t i = 0; i < meetings.size();) {
            std::size_t end = i + 1;  // of the group of meetings in contact
            while (end < meetings.size() && in_contact(o, d, meetings[end - 1], meetings[end]))
                ++end;
            const V sample_after = middle(meetings[end - 1].t, end);
            const int after = solid_at(sample_after);
            if (auto surface = surface_between(o, d, meetings, i, end, before, after, sample_before,
                                               sample_after))
                return surface;
            before = after;
            sample_before = sample_after;
            i = end;
        }
        return std::nullopt;
    }

private:
    struct Meeting {
        Real t;
        int object, face;
    };
    double priority(int solid) const { return scene_.solids[solid].interior.priority; }
    bool lets_through(int object) const {
        const scene::Texture& texture = scene_.textures[scene_.objects[object].texture];
        return texture.clear || scene::lets_light_through(texture.pigment);
    }
    bool solid_contains(int solid, const V& p) const {
        for (const int object : parts_[solid]) {
            if (bodies_[object].contains(p)) return true;
        }
        return false;
    }
    Real cosine(const V& o, const V& d, const Meeting& m) const {
        return absolute(dot(d, bodies_[m.object].normal(m.face, o + m.t * d)));
    }
    bool in_contact(const V& o, const V& d, const Meeting& a, const Meeting& b) const {
        const Real gap = b.t - a.t;
        if (gap <= contact_) return true;
        if (gap > nearby_) return false;
        const Real c = cosine(o, d, a), e = cosine(o, d, b);
        return gap * (c > e ? c : e) <= contact_;
    }

    /// The meeting of the group at which the object (or an object of the solid) really begins or
    /// ends: the one with the object on just one side of it.
    const Meeting& boundary(const V& o, const V& d, const std::vector<Meeting>& meetings,
                            std::size_t begin, std::size_t end, int solid, int object) const {
        const Meeting* any = nullptr;
        for (std::size_t i = begin; i < end; ++i) {
            const Meeting& m = meetings[i];
            if (object != nothing ? m.object != object
                                  : int(scene_.objects[m.object].solid) != solid)
                continue;
            any = &m;
            const V p = o + m.t * d,
                    step = Real(8) * contact_ * bodies_[m.object].normal(m.face, p);
            if (bodies_[m.object].contains(p - step) && !bodies_[m.object].contains(p + step))
                return m;
        }
        return any ? *any : meetings[begin];
    }

    std::optional<Surface<Real>> surface_between(const V& o, const V& d,
                                                 const std::vector<Meeting>& meetings,
                                                 std::size_t begin, std::size_t end, int before,
                                                 int after, const V& sample_before,
                                                 const V& sample_after) const {
        Surface<Real> surface;
        surface.before = before;
        surface.after = after;
        const auto met_at = [&](const Meeting& m) {
            surface.t = m.t;
            const V n = bodies_[m.object].normal(m.face, o + m.t * d);
            surface.normal = dot(n, d) > 0 ? -n : n;
        };
        // Solids that are no media end every ray at their boundary.
        for (std::size_t i = begin; i < end; ++i) {
            const int object = meetings[i].object;
            if (is_medium_[scene_.objects[object].solid]) continue;
            if (bodies_[object].contains(sample_before) == bodies_[object].contains(sample_after))
                continue;
            met_at(boundary(o, d, meetings, begin, end, nothing, object));
            surface.skin = object;
            surface.opaque = true;
            return surface;
        }
        if (before == after) return std::nullopt;

        // It belongs to the solid of higher priority: that one begins or ends here.
        const int owner = before == nothing                     ? after
                          : after == nothing                    ? before
                          : priority(after) >= priority(before) ? after
                                                                : before;
        const Meeting& m = boundary(o, d, meetings, begin, end, owner, nothing);
        met_at(m);
        surface.skin = m.object;
        if (owner == before && after != nothing) {
            // A higher solid ends inside an opaque one: that is what is seen.
            const int under = parts_[after].front();
            if (!lets_through(under)) surface.skin = under;
        }
        surface.opaque = !lets_through(surface.skin);
        const scene::Texture& skin = scene_.textures[scene_.objects[surface.skin].texture];
        if (skin.clear && medium(before).same_medium(medium(after))) return std::nullopt;
        return surface;
    }

    scene::Scene scene_;
    Real contact_, nearby_;  // beyond the second, grazing cannot bring surfaces into contact
    std::vector<Body<Real>> bodies_;
    std::vector<std::vector<int>> parts_;  // of each solid: its objects
    std::vector<bool> is_medium_;
    std::vector<int> by_priority_;
};

}  // namespace meniscus::oracle
