#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geom/transform.hpp"

namespace meniscus::lanes {

/// At most so many solids stand in a ray's list: one bit each.
inline constexpr int most_members = 241;
/// At most so many solids are tried by every ray; small spheres stand in groups.
inline constexpr int most_solids = 15;
/// Behind the members' bits each solid that is always met has one: on which side of it a ray is
/// that was born on it.
inline constexpr int list_words = (most_members + most_solids) / 64;
/// A bit for each place in the list.
using Places = std::array<std::uint64_t, list_words>;
/// Straight pieces of a lathe's profile, and crossings of it on one line.
inline constexpr int most_pieces = 14;
inline constexpr int most_lathe_crossings = 4;
/// Crossings of a mesh that are told of at a time.
inline constexpr int most_mesh_crossings = 4;

inline constexpr int no_rank = -1;

inline constexpr double unit_roundoff = 0x1p-53;
/// Chords this share of the magnitude long may be none: so near to a tangent rounding decides.
inline constexpr double thin_chord = 1e-6;

/// The last three are met by the host: any other convex solid, meshes, and any other.
enum class Kind { sphere, box, cylinder, half_space, lathe, other_convex, mesh, other };

/// By which code it is asked for its next crossing.
enum class Way { ball, floor, cylinder, box, cup, stepped_lathe, mesh, any };

/// Whether it is worth a look first whether a ray comes near it.
inline bool is_costly(Kind kind) {
    return kind != Kind::sphere && kind != Kind::half_space && kind != Kind::cylinder;
}
/// Whether the host meets it.
inline bool is_foreign(Kind kind) { return kind >= Kind::other_convex; }
/// Whether a ray may be inside of it twice.
inline bool has_two_stretches(Kind kind) {
    return kind == Kind::lathe || kind == Kind::mesh || kind == Kind::other;
}

/// Whether a crossing must say which face it is on.
inline bool has_faces(Kind kind) { return kind != Kind::sphere && kind != Kind::half_space; }

/// One straight piece of a lathe's profile: a * radius + b * height = c with (a, b) its outward
/// unit normal.
struct Piece {
    double a, b, c;
    double low_radius, high_radius, low_height, high_height;
};

/// A lathe that is a cylinder without another one that is open at its top, and the faces' numbers.
struct Cup {
    double outer_radius, inner_radius, base, floor, top;
    int base_face, outer_face, top_face, inner_face, floor_face;
};

/// A solid as the kernel sees it, in a frame of its own if `placed`. Only the numbers of its kind
/// mean something.
struct Solid {
    Kind kind = Kind::sphere;
    Way way = Way::any;
    int part = 0;        // whose it is, for the host
    int rank = no_rank;  // place in the list: higher is stronger; `no_rank`: always met
    int place = 0;       // its bit in the list
    Places stronger{};   // what hides its surface
    bool inverse = false;
    bool to_camera = true, to_mirrors = true, to_lights = true;  // which rays meet it
    bool placed = false;
    geom::Transform transform;            // from its own frame to the world, if placed
    double magnitude = 0.0;               // its largest coordinate
    double thin = 0.0, sure_start = 0.0;  // its shares in bounds of the kernel (Rays)
    geom::Vec3 middle{0.0};               // of a sphere around it, with a margin; costly kinds
    double reach = 0.0;                   // its radius
    bool is_large = false;                // few rays miss that sphere
    int paint = -1;                       // how lanes shade it, if they can

    geom::Vec3 center{0.0};           // sphere; base of a cylinder; a half-space's unit normal
    double radius = 0.0;              // sphere, cylinder
    double inverse_radius = 0.0;      // sphere
    double distance = 0.0;            // half-space
    geom::Vec3 low{0.0}, high{0.0};   // box; of a mesh the one around it, with a margin
    geom::Vec3 axis{0.0};             // cylinder: unit vector from base to cap
    double length = 0.0;              // cylinder
    std::vector<Piece> pieces;        // lathe, about its y axis
    bool is_stepped = false;          // lathe: all pieces are rings or cylinders
    bool is_cup = false;              // lathe
    Cup cup{};                        // if it is one
    double height = 0.0, size = 0.0;  // lathe: halfway up; of its profile
};

/// A solid that stands in the list, that all rays see.
inline bool is_plain(const Solid& solid) {
    return solid.rank >= 0 && !solid.inverse && solid.to_camera && solid.to_mirrors &&
           solid.to_lights;
}
/// Whether it is kept where a ray leaves it that enters at its next crossing.
inline bool has_end(const Solid& solid) {
    return solid.way != Way::floor && (solid.way == Way::mesh || !has_two_stretches(solid.kind));
}
/// A sphere of that kind in the world's frame.
inline bool is_plain_ball(const Solid& solid) {
    return solid.kind == Kind::sphere && !solid.placed && is_plain(solid);
}

/// A half-space that stands in no list, in the world's frame, that all rays see.
inline bool is_plain_floor(const Solid& solid) {
    return solid.kind == Kind::half_space && solid.rank < 0 && !solid.placed && !solid.inverse &&
           solid.to_camera && solid.to_mirrors && solid.to_lights;
}

/// Room for rounding to single precision, in numbers up to 1: sums of a few products.
inline constexpr double group_slack = 1e-5;

/// Eight small spheres and a sphere around them. All seen from the middle of the one around all
/// groups, in units of its radius, with `group_slack`.
struct Group {
    static constexpr int size = 8;
    float x, y, z, reach;
    float power;  // reach^2 - |center|^2
    struct Spheres {
        std::array<float, size> x, y, z, reach, power;
    } spheres;
    std::array<int, size> rank;  // `no_rank` where the group has fewer
};

/// What stands at one rank of the list.
struct Member {
    int part = 0;
    double ior = 1.0;
    std::uint32_t medium = 0;  // equal for media that are alike
    bool attenuates = false;
    bool clear = true;  // its surface is exact Fresnel reflection and refraction, and nothing else
    Places stronger{};  // what hides its surface
    bool in_group = false;
    geom::Vec3 center{0.0};  // if in a group
    double radius = 0.0, inverse_radius = 0.0;
};

/// An opaque surface that lanes can shade: diffuse under point lights, of one colour or chequered.
struct Paint {
    bool is_checker = false;
    geom::Vec3 colours[2];
    geom::Mat3 to_cells{1.0};  // checker: a point's cell is to_cells * point + shift, rounded down
    geom::Vec3 shift{0.0};
    geom::Vec3 glow{0.0};  // ambient light and emission, as a share of the colour
    double diffuse = 0.0;
    bool is_open = false;  // nothing comes between its points and a light
};

/// A point light that fades with nothing.
struct Light {
    geom::Vec3 position, colour;
};

/// Members of one priority that may meet though they are unlike: by kinds, those of one kind are
/// alike. Which of two kinds a ray entered last no rank can say; so a ray that is in both is left
/// to the host.
struct Tie {
    std::vector<Places> kinds;
};

/// Whether something stronger is around where a ray crosses a solid.
enum class Hiding { never, always, by_list };

/// What is known of rays that are in one of a few solids and in nothing stronger, or in the open:
/// what they may come to before they leave that. Solids are told by their places in the program.
struct Surroundings {
    Places places{};                          // of those few; none: the open
    std::vector<int> all;                     // that they may come to, in the program's order
    std::vector<int> balls, others, foreign;  // each by its code, meshes apart
    std::vector<int> floors, cornered;        // whose faces have code of their own
    bool lathes = true, small_spheres = true, surfaces = true;  // the rest
    std::array<Hiding, most_solids> hiding{};                   // of all
    bool is_open = false;                                       // they are in no solid
    int top = no_rank;                                          // the solid, if it is one
};

/// A scene as tables: what the kernel needs to know of it and no more. Ranks sort the members by
/// priority.
struct Program {
    std::vector<Solid> solids;
    std::vector<Group> groups;
    geom::Vec3 groups_middle{0.0};  // of a sphere around all of them
    double groups_reach = 0.0;
    std::vector<Member> members;    // by rank
    Places member_bits{};           // where they are in a list
    std::size_t listed_solids = 0;  // so many are members: the first of `solids`
    std::vector<Tie> ties;
    std::vector<Paint> paints;
    std::vector<Light> lights;                               // if there are paints
    bool all_painted = false;                                // all surfaces that no list has
    Member outside;                                          // the medium around everything
    double tolerance_units = 16.0, contact_tolerance = 0.0;  // docs/numerics.md
    double largest_magnitude = 0.0;                          // over all solids and spheres
    bool one_tolerance = false;  // the magnitudes are so alike that the largest serves for all

    // What the scene has and needs; the rest is skipped.
    bool attenuates = true, uses_keys = true;
    bool grey = false;       // only rays to lights have colours: a ray's light is its weight
    int words = list_words;  // of the list
    std::vector<int> cheap_first, foreign;  // solids with code of their own, and the host's
    std::vector<int> balls;                 // plain ones
    std::vector<int> floors;                // plain ones
    std::vector<int> lathes;                // in the world's frame, no complements
    std::vector<int> cornered;              // all but these
    bool has_surfaces = true;               // solids that stand in no list
    bool has_faces = true;                  // solids of more than one face
    std::vector<int> meshes;                // the strongest first
    Surroundings everything;                // of rays that may be anywhere
    std::vector<Surroundings> bins;   // those of rays that see wait in; the strongest solids first,
                                      // the open last
    bool only_opaque_shades = false;  // rays to lights care for `shades` alone, and no list
    std::vector<int> shades;
    bool has_meshes = false;
    bool has_dressed = true;       // members whose skins are not clear
    bool ior_tells_medium = true;  // media of one index are alike

    bool whitted = true, sampled = false;  // kind of ray tree; neither: every branch
    int most_levels = 5;
    double least_weight = 0.0;
    bool constant_sky = false;  // then all that escapes into the outside sees `sky`
    geom::Vec3 sky{0.0};
    double units = 0x1p36;  // of the pixels' fixed-point sums, in one unit of light
};

}  // namespace meniscus::lanes
