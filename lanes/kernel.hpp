#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geom/ray.hpp"
#include "lanes/camera.hpp"
#include "lanes/stacks.hpp"

namespace meniscus::lanes {

/// Where a ray met a surface that the kernel leaves to its host.
struct Surface {
    WaitingRay ray;  // as it set out; its throughput has the way's attenuation in it
    double t = 0.0;
    geom::Vec3 point{0.0}, normal{0.0};  // the outward unit normal of the solid
    int part = -1, face = 0;             // whose surface
    bool is_member = false;              // false: a surface that is always met
    int rank_before = no_rank, rank_after = no_rank;
    Places before{}, after{};
    std::uint64_t contacts = 0, sphere_contacts = 0, mesh_contacts = 0;
    double magnitude = 0.0;  // M at the point
    int level = 0;

    /// A ray that goes on from the point, on the near side (`before`) or behind it (`after`).
    WaitingRay next(const geom::Vec3& direction, bool behind) const;
};

/// What a tile did.
struct Counts {
    std::uint64_t segments = 0, true_crossings = 0, false_crossings = 0;
    std::uint64_t reflected = 0, refracted = 0, shadows = 0;
    std::uint64_t handed_over = 0;  // rays that the host followed
    int deepest_level = 0;
};

/// A crossing of a line with a foreign solid.
struct Met {
    double t;
    geom::Face face;
    double slope;  // direction . normal, negative where the line enters; only its sign holds far
                   // from the line's origin
};

/// A ray that may come to a mesh, as its list has it.
struct MeshRay {
    geom::Ray ray;
    double birth_magnitude;
    double farthest;             // what lies beyond is not asked for
    bool knows_side, is_inside;  // whether it starts inside of the shape, if that is known
    geom::Face born_on;          // a triangle, or no_face
    bool is_hidden;              // something stronger is there: it does not end at the mesh
    double slack, slack_per_t;   // else what it needs goes so far beyond its end
};

/// What it comes to.
struct MeshMet {
    bool is_sure = false;  // else it is too close to call
    bool starts_inside = false;
    int count = 0;
    double known = 0.0;                                  // so far these are all
    std::array<geom::Crossing, most_mesh_crossings> at;  // in turn leaving and entering
};

/// Who owns the picture, textures and lights, and the general way of following a ray.
class Host {
public:
    virtual ~Host() = default;
    /// Where all camera rays start, if they do so in one place with one list: then the kernel makes
    /// them, through points of the film that it asks for.
    virtual const Camera* camera() const { return nullptr; }
    /// The next of these points, up to `wanted`; their number, 0 when all are under way.
    virtual std::size_t more_points(FilmPoints& /*points*/, std::size_t /*wanted*/) { return 0; }
    /// Pushes up to `wanted` further camera rays, none when all are under way; if there is no such
    /// camera.
    virtual void more_rays(Stacks& stacks, std::size_t wanted) = 0;
    /// The light of the sky in this direction, seen from the medium at `rank`.
    virtual geom::Vec3 sky(const geom::Vec3& direction, int rank) = 0;
    /// How much light is left after a way in the medium at `rank`.
    virtual geom::Vec3 transmittance(int rank, double way, bool of_shadow) = 0;
    /// Shades a surface: returns its own light times the throughput, and pushes the rays that go
    /// on.
    virtual geom::Vec3 shade(const Surface& surface, Stacks& stacks) = 0;
    /// What a foreign convex solid leaves of a line; `pin` as for geom::Sphere::interval.
    virtual geom::Interval interval(const Solid& solid, const geom::Ray& ray, geom::Face pin) = 0;
    /// The crossings of a line with a foreign solid, sorted; their number, or -1 if there are more
    /// than `most_lathe_crossings`.
    virtual int crossings(const Solid& solid, const geom::Ray& ray, Met* out) = 0;
    /// Where rays come to a mesh: an answer for each of them.
    virtual void meet_mesh(const Solid& solid, std::span<const MeshRay> rays, MeshMet* met) = 0;
    /// Puts a point back on a face of a foreign solid: returns the outward unit normal there.
    virtual geom::Vec3 put_on_face(const Solid& solid, geom::Face face, geom::Vec3& point) = 0;
    /// Follows a ray and all that comes of it: returns the light times the throughput. For what is
    /// too close to call in lanes.
    virtual geom::Vec3 follow(const WaitingRay& ray) = 0;
};

/// The instruction sets that the kernel can use on this machine, best first.
std::vector<std::string> instruction_sets();

/// Follows all rays that the host has and adds their light to `sums`: for each pixel (RayCode) four
/// numbers, red, green and blue in 1 / program.units and the count of leaves. Sums of integers are
/// the same in every order, so the number of lanes changes nothing. `instruction_set` is one of
/// `instruction_sets()`; empty: the best.
Counts run(const Program& program, Host& host, Stacks& stacks, std::int64_t* sums,
           const std::string& instruction_set = {});

}  // namespace meniscus::lanes
