// The rays of one step and what is found out about them.

#if defined(MENISCUS_LANES_BATCH) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_BATCH
#undef MENISCUS_LANES_BATCH
#else
#define MENISCUS_LANES_BATCH
#endif

#include "lanes/kernel.hpp"
#include "lanes/spans-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

/// Numbers of all lanes, for what is done one lane at a time.
template <class T>
struct Column {
    alignas(64) T at[lanes];
    Column() = default;
    HWY_INLINE Column(F x) { store(x, at); }
    HWY_INLINE Column(U x) { store(x, at); }
    T& operator[](std::size_t lane) { return at[lane]; }
    T operator[](std::size_t lane) const { return at[lane]; }
};
using Doubles = Column<double>;
using Words = Column<std::uint64_t>;

/// Calls visit(lane) for each lane of a mask.
template <class Visit>
HWY_INLINE void for_each(std::uint32_t lane_bits, Visit&& visit) {
    for (std::uint32_t left = lane_bits; left; left &= left - 1)
        visit(std::size_t(__builtin_ctz(left)));
}
template <class Visit>
HWY_INLINE void for_each(M mask, Visit&& visit) {
    for_each(bits(mask), visit);
}

/// All rays as numbers.
struct Line3 {
    Doubles ox, oy, oz, dx, dy, dz;
    HWY_INLINE explicit Line3(const Rays& rays)
        : ox(rays.world.origin.x),
          oy(rays.world.origin.y),
          oz(rays.world.origin.z),
          dx(rays.world.direction.x),
          dy(rays.world.direction.y),
          dz(rays.world.direction.z) {}
    geom::Ray ray(std::size_t lane) const {
        geom::Ray result;
        result.origin = {ox[lane], oy[lane], oz[lane]};
        result.direction = {dx[lane], dy[lane], dz[lane]};
        return result;
    }
};

/// A list of each lane's ray: a bit for each place.
struct List {
    U word[list_words];  // as many as the program has
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

/// The solid on top of each ray's list, and what it is made of, so far as the program asks.
struct Top {
    F rank;  // `no_rank`: outside of all
    F ior, medium;
    F face;  // of its crossing in the event, if it has one
    M dressed, attenuates;

    Top() = default;
    HWY_INLINE explicit Top(const Member& outside)
        : rank(double(no_rank)),
          ior(outside.ior),
          medium(double(outside.medium)),
          face(0.0),
          dressed(no_lanes()),
          attenuates(outside.attenuates ? !no_lanes() : no_lanes()) {}

    /// Where `which`, the solid at `solid_rank` is on top of those so far.
    HWY_INLINE void cover(M which, int solid_rank, const Program& program) {
        const Member& member = program.members[std::size_t(solid_rank)];
        rank = select(which, F(double(solid_rank)), rank);
        ior = select(which, F(member.ior), ior);
        if (!program.ior_tells_medium) medium = select(which, F(double(member.medium)), medium);
        if (program.has_dressed) dressed = member.clear ? but_not(dressed, which) : dressed | which;
        if (program.attenuates)
            attenuates = member.attenuates ? attenuates | which : but_not(attenuates, which);
    }
    /// Where the members at `ranks`, of the lanes `which`, are.
    HWY_INLINE void cover(std::uint32_t which, const Doubles& ranks, const Program& program) {
        if (which == 0) return;
        Doubles at(rank), iors(ior), media(medium);
        std::uint32_t are_dressed = bits(dressed), attenuate = bits(attenuates);
        for_each(which, [&](std::size_t lane) {
            const Member& member = program.members[std::size_t(ranks[lane])];
            at[lane] = ranks[lane];
            iors[lane] = member.ior;
            media[lane] = double(member.medium);
            const std::uint32_t bit = 1u << lane;
            are_dressed = member.clear ? are_dressed & ~bit : are_dressed | bit;
            attenuate = member.attenuates ? attenuate | bit : attenuate & ~bit;
        });
        rank = load(at.at);
        ior = load(iors.at);
        if (!program.ior_tells_medium) medium = load(media.at);
        if (program.has_dressed) dressed = mask_of(are_dressed);
        if (program.attenuates) attenuates = mask_of(attenuate);
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

/// The spheres, of all sizes, that events are on.
struct Round {
    M which;
    F3 center;
    F radius, inverse_radius;
};

HWY_INLINE Top select(M m, const Top& x, const Top& y, const Program& program) {
    Top result = y;
    result.rank = select(m, x.rank, y.rank);
    result.ior = select(m, x.ior, y.ior);
    result.face = select(m, x.face, y.face);
    if (!program.ior_tells_medium) result.medium = select(m, x.medium, y.medium);
    if (program.has_dressed) result.dressed = select_mask(m, x.dressed, y.dressed);
    if (program.attenuates) result.attenuates = select_mask(m, x.attenuates, y.attenuates);
    return result;
}

/// The nearest true crossing so far.
struct Crossing {
    F t;
    U index;  // of the solid, or `is_small_sphere`
    F face;   // whole number
};
inline constexpr std::uint64_t is_small_sphere = most_solids;

struct Batch {
    RayStack* stack = nullptr;       // where the rays stood
    std::size_t size = 0, base = 0;  // rays, and the place of the first
    bool is_shadow = false;          // all of them go to lights, or none
    // As they set out.
    Rays rays;
    F3 throughput;
    F weight, way_before;
    U code, key, sphere_contacts;
    List inside;
    M is_mirrored;
    // Where each solid is next crossed, and on which face.
    F crossing[most_solids], crossing_face[most_solids];
    F first, second;  // the two nearest of these and of small spheres' crossings
    F ends;           // the nearest crossing that is not its solid's next
    F sphere_first;   // the nearest with small spheres
    M doubt;          // lanes that need all stretches
    // Where each solid's stretches of the rays lie (2 i and 2 i + 1 for solid i).
    Stretch stretches[2 * most_solids];
    bool is_near[most_solids];  // whether there are any
    SphereStretches spheres[lanes];
    Doubles sphere_ranks;            // of nearest crossings with small spheres
    std::uint32_t near_spheres = 0;  // lanes that have some
    Crossing nearest;
    M unsure;  // too close to call
    // The event: what is there just before and just after it.
    M met;
    F t;
    List before, after;
    F surface, surface_face;  // index of the solid that is always met
    U contacts;
    F false_crossings;
    U sphere_contacts_after;
    Top before_top, after_top;
    // What is met: no surface, a clear one, one that lanes can shade, one that the host shades.
    U level;
    M same, nothing, glass, painted, dressed;
    M by_surface;   // it stands in no list
    F owner, face;  // rank of the solid whose surface it is
    U owner_index;  // and its place among the program's, or `is_small_sphere`
    F3 point, normal;
    F magnitude;  // M at the point
};

/// The face number of a contact, in its place in the word of all contacts; 15: some face beyond the
/// numbers that fit.
HWY_INLINE U contact_word(F face, int index) {
    const F with_exponent = min(face + F(1.0), F(15.0)) + F(0x1p52);
    return shift_left(as_words(with_exponent) & U(15), 4 * index);
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
