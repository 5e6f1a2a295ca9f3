// The rays of one step and what is found out about them.

#if defined(MENISCUS_LANES_BATCH) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_BATCH
#undef MENISCUS_LANES_BATCH
#else
#define MENISCUS_LANES_BATCH
#endif

#include "lanes/columns-inl.hpp"
#include "lanes/kernel.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

/// A list of each lane's ray: a bit for each place.
struct List {
    U word[list_words];  // as many as the program has
};

/// The same, lane by lane.
struct ListWords {
    Words word[list_words];
    const Program& program;

    HWY_INLINE ListWords(const List& list, const Program& of) : program(of) {
        for (int w = 0; w < program.words; ++w) word[w] = Words(list.word[w]);
    }
    /// The strongest member's rank, or `no_rank`.
    int top(std::size_t lane) const {
        for (int w = program.words - 1; w >= 0; --w) {
            const std::uint64_t members = word[w][lane] & program.member_bits[std::size_t(w)];
            if (members != 0) return 64 * w + 63 - __builtin_clzll(members);
        }
        return no_rank;
    }
};

/// A stretch of one lane's ray inside a small sphere.
struct SphereStretch {
    double in, out;
    int rank;
};
struct SphereStretches {
    static constexpr int most = 24;
    SphereStretch at[most];
    int size;
};

/// A solid that stands in the list, as far as lists ask: its bit, and what it is made of.
struct Listed {
    std::uint64_t bit;
    std::size_t word;
    double ior, medium;
    bool clear, attenuates;
    bool has_faces;
};

/// What each ray is in, so far as the program asks.
struct Medium {
    F ior, medium;
    M dressed, attenuates;

    Medium() = default;
    HWY_INLINE explicit Medium(const Member& member)
        : ior(member.ior),
          medium(double(member.medium)),
          dressed(member.clear ? no_lanes() : !no_lanes()),
          attenuates(member.attenuates ? !no_lanes() : no_lanes()) {}

    /// Where `which`, the rays are in the solid.
    HWY_INLINE void become(M which, const Listed& solid, const Program& program) {
        ior = select(which, F(solid.ior), ior);
        if (!program.ior_tells_medium) medium = select(which, F(solid.medium), medium);
        if (program.has_dressed) dressed = solid.clear ? but_not(dressed, which) : dressed | which;
        if (program.attenuates)
            attenuates = solid.attenuates ? attenuates | which : but_not(attenuates, which);
    }
    /// Where `which`, they are in those at `ranks`.
    HWY_INLINE void become(std::uint32_t which, const Doubles& ranks, const Program& program) {
        if (which == 0) return;
        Doubles iors(ior), media(medium);
        std::uint32_t are_dressed = bits(dressed), attenuate = bits(attenuates);
        for_each(which, [&](std::size_t lane) {
            const Member& member = program.members[std::size_t(ranks[lane])];
            iors[lane] = member.ior;
            media[lane] = double(member.medium);
            const std::uint32_t bit = 1u << lane;
            are_dressed = member.clear ? are_dressed & ~bit : are_dressed | bit;
            attenuate = member.attenuates ? attenuate | bit : attenuate & ~bit;
        });
        ior = load(iors.at);
        if (!program.ior_tells_medium) medium = load(media.at);
        if (program.has_dressed) dressed = mask_of(are_dressed);
        if (program.attenuates) attenuates = mask_of(attenuate);
    }
};

HWY_INLINE Medium select(M m, const Medium& x, const Medium& y, const Program& program) {
    Medium result = y;
    result.ior = select(m, x.ior, y.ior);
    if (!program.ior_tells_medium) result.medium = select(m, x.medium, y.medium);
    if (program.has_dressed) result.dressed = select_mask(m, x.dressed, y.dressed);
    if (program.attenuates) result.attenuates = select_mask(m, x.attenuates, y.attenuates);
    return result;
}

/// Events on solids that are always met.
struct Owner {
    M which;
    U index;
    F face;

    HWY_INLINE Owner() : which(no_lanes()), index(0), face(0.0) {}
    /// The first that comes has it.
    HWY_INLINE void own(M lanes_of_it, std::size_t solid, F its_face) {
        lanes_of_it = but_not(lanes_of_it, which);
        which = which | lanes_of_it;
        index = select(lanes_of_it, U(solid), index);
        face = select(lanes_of_it, its_face, face);
    }
};

/// Rays that go on from an event, apart from what it says itself.
struct Child {
    F3 direction, light;  // `light`: where rays have colours
    F weight;             // of rays that are not shadow rays
    F t_max;              // of shadow rays
    F way;
    U code, key;
};

/// Light on its way to the rays' pixels, in fixed point: sums of it are exact.
struct PixelLight {
    U red, green, blue, count;

    HWY_INLINE PixelLight() : red(0), green(0), blue(0), count(0) {}
    HWY_INLINE void add(M which, const F3& light, double units) {
        red = red + only(which, round_to_word(F(units) * light.x));
        green = green + only(which, round_to_word(F(units) * light.y));
        blue = blue + only(which, round_to_word(F(units) * light.z));
        count = count + only(which, U(1));
    }
};

/// The spheres, of all sizes, that events are on.
struct Round {
    M which;
    F3 center;
    F radius, inverse_radius;
};

/// The nearest true crossing so far.
struct Crossing {
    F t;
    U index;  // of the solid, or `is_small_sphere`
    F face;   // whole number
};
inline constexpr std::uint64_t is_small_sphere = most_solids;

/// What is known of all crossings so far.
struct Findings {
    Crossing nearest;
    F first;   // the nearest of solids' next crossings, true or not
    F second;  // the nearest of all others that are known
    F third;   // of solids that are not convex, the nearest that is not their next
    M doubt;   // lanes that need all stretches

    HWY_INLINE Findings()
        : nearest{F(infinity), U(0), F(0.0)},
          first(infinity),
          second(infinity),
          third(infinity),
          doubt(no_lanes()) {}
};

struct Batch {
    RayStack* stack = nullptr;       // where the rays stood
    std::size_t size = 0, base = 0;  // rays, and the place of the first
    bool is_shadow = false;          // all of them go to lights, or none
    const Surroundings* around = nullptr;
    // As they set out.
    Rays rays;
    F3 throughput;
    F weight, way_before;
    U code, key, sphere_contacts, mesh_contacts;
    List inside;
    M is_mirrored;
    // Where each solid that they may come to is next crossed, and on which face.
    F crossing[most_solids], crossing_face[most_solids];
    F crossing_end[most_solids];  // where they are left again that are entered there, if `has_end`
    // Where each solid's stretches of the rays lie (2 i and 2 i + 1 for solid i).
    Stretch stretches[2 * most_solids];
    bool is_near[most_solids];  // whether there are any
    SphereStretches spheres[lanes];
    Doubles sphere_ranks;            // of nearest crossings with small spheres, then of owners
    std::uint32_t near_spheres = 0;  // lanes that have some
    F mesh_known;                    // so far all crossings with meshes are known
    M mesh_doubt;                    // lanes for which a mesh is too close to call
    Crossing nearest;
    M unsure;  // too close to call
    // The event: what is there just before and just after it.
    M met;
    F t;
    List before, after;
    U contacts;
    bool has_passed = false;  // whether there are false crossings
    F false_crossings;
    U sphere_contacts_after, mesh_contacts_after;
    Medium medium_before, medium_after;
    // What is met: no surface, a clear one, one that lanes can shade, one that the host shades.
    U level;
    M same, nothing, glass, painted, dressed;
    M by_surface;     // it stands in no list
    M owner_dressed;  // the skin of the solid whose surface it is
    U owner_index;    // its place among the program's, or `is_small_sphere`
    F face;
    F3 point, normal;
    F magnitude;  // M at the point
};

/// The face of a contact with `solid`, plus 1, in its place in the word of all contacts; 15: some
/// face beyond the numbers that fit, which only the host's solids have.
HWY_INLINE U contact_word(const Solid& solid, F face, std::size_t index) {
    if (!has_faces(solid.kind)) return U(1ull << (4 * index));
    const F number = is_foreign(solid.kind) ? min(face, F(14.0)) : face;
    return shift_left(as_words(number + F(0x1p52 + 1.0)) & U(15), int(4 * index));
}

/// Adds the triangle of a further mesh to a word of them; rays in contact with three are `torn`.
HWY_INLINE void touch_mesh(U& contacts, M touches, F face, M& torn) {
    const U triangle = as_words(face + F(0x1p52 + 1.0)) & U(0xffffffffu);
    torn = torn | (touches & !(shift_right(contacts, 32) == U(0)));
    contacts = select(touches, shift_left(contacts, 32) | triangle, contacts);
}

/// The stretch of a ray in one small sphere, as `sphere_span` and `resolve` have it for lanes;
/// false if there is none.
HWY_INLINE bool sphere_stretch(const Program& program, const geom::Vec3& o, const geom::Vec3& d,
                               const geom::Vec3& c, double r, bool inside, bool has_contact,
                               double largest, double birth, SphereStretch& result, bool& unsure) {
    const geom::Vec3 e = o - c;
    const double b = e.x * d.x + e.y * d.y + e.z * d.z;
    double t0, t1;
    bool hit;
    if (has_contact) {
        t0 = std::min(0.0, -b - b);
        t1 = std::max(0.0, -b - b);
        hit = t0 < t1;
    } else {
        const geom::Vec3 f = e - b * d;
        const double discriminant = r * r - (f.x * f.x + f.y * f.y + f.z * f.z);
        hit = discriminant > 0.0;
        const double half = std::sqrt(std::max(discriminant, 0.0));
        t0 = -b - half;
        t1 = -b + half;
    }
    const double size = std::max({std::abs(c.x), std::abs(c.y), std::abs(c.z)}) + r;
    const double units = program.tolerance_units * unit_roundoff;
    const double sure_start = 2.0 * std::max(units * (birth + size), program.contact_tolerance);
    if (inside) {
        if (t1 < -sure_start && !has_contact) unsure = true;
        result.in = -infinity;
        result.out = std::max(t1, 0.0);
        return true;
    }
    if (!hit || !(t1 > 0.0)) return false;
    const double start = std::max(t0, 0.0), chord = t1 - start;
    const double magnitude = largest + size + start;
    if (chord <= std::max(units * magnitude, program.contact_tolerance)) return false;
    if (chord < std::max(1e-6 * magnitude, 2.0 * program.contact_tolerance)) unsure = true;
    if (t0 < -sure_start && !has_contact) unsure = true;
    result.in = start;
    result.out = t1;
    return true;
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
