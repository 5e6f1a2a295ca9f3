// Small spheres, which stand in groups: each is met by few rays.

#if defined(MENISCUS_LANES_SMALL_SPHERES) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_SMALL_SPHERES
#undef MENISCUS_LANES_SMALL_SPHERES
#else
#define MENISCUS_LANES_SMALL_SPHERES
#endif

#include "lanes/kernel-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

/// Lanes whose rays meet a group's sphere before what is nearest so far.
struct GroupTest {
    F reach;  // -|o|^2, with room for rounding
    F along;  // o . d
    const Rays& rays;

    HWY_INLINE explicit GroupTest(const Rays& of)
        : reach(F(-1.0 + 1e-14) * dot(of.world.origin, of.world.origin)),
          along(dot(of.world.origin, of.world.direction)),
          rays(of) {}

    HWY_INLINE M met(const Group& group, F nearest) const {
        const F3 c(group.center);
        const F b = along - dot(c, rays.world.direction);
        const F b2 = b * b;
        // r^2 - |o - c|^2 + b^2
        const F twice = dot(F3(2.0 * group.center), rays.world.origin);
        const F room = ((F(group.power) + reach) + twice) + b2;
        const F beyond = b + (nearest * F(1.0 + 1e-6) + (rays.margin + F(group.radius)));
        return (F(0.0) < room) & ((b < F(0.0)) | (b2 < room)) & (F(0.0) < beyond);
    }
};

/// Small spheres are met by few rays each: lane by lane, eight spheres at once. Draws `nearest`
/// nearer where one of them is a true crossing.
HWY_INLINE void Kernel::find_small_spheres(Batch& batch) {
    using Stack = RayStack;
    const Rays& rays = batch.rays;
    M named = !(batch.sphere_contacts == U(0));
    for (int w = 0; w < program_.words; ++w)
        named = named | shares(batch.inside.word[w], U(group_bits_[w]));
    named = named & rays.active;
    const M near_all = rays.active & meet_sphere(rays, program_.groups_middle,
                                                 program_.groups_reach, batch.nearest);
    if (!any(named | near_all)) return;

    // The rays are still on the stack, one by one.
    const auto number = [&](Stack::Field field) { return (*batch.stack)[field] + batch.base; };
    const auto word = [&](int field) {
        return batch.stack->word(Stack::Field(field)) + batch.base;
    };
    const double *const ox = number(Stack::ox), *const oy = number(Stack::oy),
                        *const oz = number(Stack::oz), *const dx = number(Stack::dx),
                        *const dy = number(Stack::dy), *const dz = number(Stack::dz),
                        *const birth = number(Stack::birth);
    const std::uint64_t* const sphere_contacts = word(Stack::sphere_contacts);
    const std::uint64_t* inside[list_words];
    for (int w = 0; w < program_.words; ++w) inside[w] = word(Stack::inside + w);
    Doubles near(batch.nearest), pivot(batch.pivot_magnitude);
    std::uint32_t doubtful = 0, drawn = 0;

    const auto offer = [&](std::size_t lane, int rank, bool is_inside, bool has_contact) {
        const Member& member = program_.members[std::size_t(rank)];
        SphereStretch stretch{};
        bool doubt = false;
        const geom::Vec3 origin{ox[lane], oy[lane], oz[lane]};
        const double largest = geom::max_abs(origin);
        const bool met = sphere_stretch(program_, origin, {dx[lane], dy[lane], dz[lane]},
                                        member.center, member.radius, is_inside, has_contact,
                                        largest, std::max(birth[lane], largest), stretch, doubt);
        if (doubt) doubtful |= 1u << lane;
        if (!met) return;
        stretch.rank = rank;
        SphereStretches& list = batch.spheres[lane];
        if (!(batch.near_spheres >> lane & 1u)) list.size = 0;
        batch.near_spheres |= 1u << lane;
        if (list.size == SphereStretches::most) {
            doubtful |= 1u << lane;
            return;
        }
        list.at[list.size++] = stretch;
        std::uint64_t hidden = 0;
        for (int w = 0; w < program_.words; ++w)
            hidden |= inside[w][lane] & member.stronger[std::size_t(w)];
        const double candidate = is_inside ? stretch.out : stretch.in;
        if (hidden == 0 && candidate < near[lane]) {
            near[lane] = candidate;
            drawn |= 1u << lane;
            pivot[lane] = magnitudes_[std::size_t(rank)];
        }
    };
    // Those that the list or a contact names, first: no box can hide them.
    for_each(named, [&](std::size_t lane) {
        const int contact[2] = {int(sphere_contacts[lane] & 0xffffffffu) - 1,
                                int(sphere_contacts[lane] >> 32) - 1};
        for (int w = 0; w < program_.words; ++w) {
            for (std::uint64_t left = inside[w][lane] & group_bits_[w]; left; left &= left - 1) {
                const int rank = 64 * w + __builtin_ctzll(left);
                offer(lane, rank, true, rank == contact[0] || rank == contact[1]);
            }
        }
        for (const int rank : contact) {
            if (rank >= 0 && !(inside[rank / 64][lane] >> (rank % 64) & 1u))
                offer(lane, rank, false, true);
        }
    });
    const auto try_group = [&](const Group& group, std::size_t lane) HWY_ATTR {
        const auto x = hn::Set(doubles, ox[lane]), y = hn::Set(doubles, oy[lane]),
                   z = hn::Set(doubles, oz[lane]);
        const auto u = hn::Set(doubles, dx[lane]), v = hn::Set(doubles, dy[lane]),
                   w = hn::Set(doubles, dz[lane]);
        for (std::size_t part = 0; part < Group::size; part += width) {
            const auto ex = hn::Sub(x, hn::LoadU(doubles, &group.x[part])),
                       ey = hn::Sub(y, hn::LoadU(doubles, &group.y[part])),
                       ez = hn::Sub(z, hn::LoadU(doubles, &group.z[part]));
            const auto along = hn::Add(hn::Add(hn::Mul(ex, u), hn::Mul(ey, v)), hn::Mul(ez, w));
            const auto fx = hn::Sub(ex, hn::Mul(along, u)), fy = hn::Sub(ey, hn::Mul(along, v)),
                       fz = hn::Sub(ez, hn::Mul(along, w));
            const auto r = hn::LoadU(doubles, &group.r[part]);
            const auto space = hn::Sub(
                hn::Mul(r, r), hn::Add(hn::Add(hn::Mul(fx, fx), hn::Mul(fy, fy)), hn::Mul(fz, fz)));
            const auto ahead =
                hn::Or(hn::Lt(along, hn::Zero(doubles)), hn::Lt(hn::Mul(along, along), space));
            std::uint8_t hits[8] = {};
            hn::StoreMaskBits(doubles, hn::And(hn::Gt(space, hn::Zero(doubles)), ahead), hits);
            for (std::uint32_t hit = hits[0] & ((1u << width) - 1u); hit; hit &= hit - 1) {
                const int rank = group.rank[part + std::size_t(__builtin_ctz(hit))];
                if (rank < 0 || inside[rank / 64][lane] >> (rank % 64) & 1u) continue;
                if (int(sphere_contacts[lane] & 0xffffffffu) == rank + 1 ||
                    int(sphere_contacts[lane] >> 32) == rank + 1)
                    continue;
                offer(lane, rank, false, false);
            }
        }
    };
    const GroupTest test(rays);
    F nearest = drawn ? load(near.at) : batch.nearest;
    for (const Group& group : program_.groups) {
        drawn = 0;
        for_each(near_all & test.met(group, nearest),
                 [&](std::size_t lane) HWY_ATTR { try_group(group, lane); });
        if (drawn) nearest = load(near.at);
    }
    batch.nearest = nearest;
    batch.pivot_magnitude = load(pivot.at);
    batch.unsure = batch.unsure | mask_of(doubtful);
}

/// The lanes whose events small spheres own.
HWY_INLINE void Kernel::add_small_spheres(const Batch& batch, M by_member, Round& round,
                                          F& owner_magnitude) const {
    const Doubles ranks(batch.owner);
    Doubles x, y, z, radius, inverse, magnitude;
    std::uint32_t here = 0;
    for_each(batch.near_spheres & bits(by_member), [&](std::size_t lane) {
        const int rank = int(ranks[lane]);
        const Member& member = program_.members[std::size_t(rank)];
        if (!member.in_group) return;
        x[lane] = member.center.x;
        y[lane] = member.center.y;
        z[lane] = member.center.z;
        radius[lane] = member.radius;
        inverse[lane] = member.inverse_radius;
        magnitude[lane] = magnitudes_[std::size_t(rank)];
        here |= 1u << lane;
    });
    if (here == 0) return;
    const M which = mask_of(here);
    round.add(which, {load(x.at), load(y.at), load(z.at)}, load(radius.at), load(inverse.at));
    if (!program_.one_tolerance)
        owner_magnitude = select(which, load(magnitude.at), owner_magnitude);
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
