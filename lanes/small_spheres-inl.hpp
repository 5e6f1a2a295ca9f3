// Small spheres, which stand in groups: each is met by few rays.

#if defined(MENISCUS_LANES_SMALL_SPHERES) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_SMALL_SPHERES
#undef MENISCUS_LANES_SMALL_SPHERES
#else
#define MENISCUS_LANES_SMALL_SPHERES
#endif

#include "lanes/kernel-inl.hpp"
#include "lanes/singles-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

/// Tells which rays meet a group's sphere before what is nearest so far, and which of its spheres
/// one ray meets; and some that they just do not. In single precision, for rays that meet the
/// sphere around all groups: seen from its middle, and in units of its radius, no number that
/// decides is larger than 1.
class GroupTest {
public:
    HWY_INLINE GroupTest(const Program& program, const Rays& rays, const Passing& middle, F nearest)
        : per_reach_(1.0 / program.groups_reach), margin_(rays.margin(program)) {
        along_ = per_reach_ * middle.along;
        const S scale = singles(float(1.0 / program.groups_reach));
        dx_ = singles(rays.world.direction.x);
        dy_ = singles(rays.world.direction.y);
        dz_ = singles(rays.world.direction.z);
        px_ = scale * singles(middle.foot.x);
        py_ = scale * singles(middle.foot.y);
        pz_ = scale * singles(middle.foot.z);
        lack_ = (scale * scale) * singles(middle.square);
        start_ = singles(along_ - F(group_slack) * (F(1.0) + abs(along_)));
        come_near(nearest);
    }
    HWY_INLINE void come_near(F nearest) {
        const F limit = min(along_ + per_reach_ * (nearest * F(1.0 + 1e-6) + margin_), F(far_away));
        limit_ = singles(limit + F(group_slack) * (F(1.0) + abs(limit)));
    }

    /// A bit for each lane.
    HWY_INLINE std::uint32_t met(const Group& group) const {
        const S x = singles(group.x), y = singles(group.y), z = singles(group.z),
                r = singles(group.reach);
        const S along = x * dx_ + y * dy_ + z * dz_;
        const S beside = x * px_ + y * py_ + z * pz_;
        // r^2 - |c - p|^2 + (c . d)^2
        const S room = (singles(group.power) - lack_) + (beside + beside) + along * along;
        return (singles(0.0f) < room) & (start_ < along + r) & (along - r < limit_);
    }

    /// The numbers of all lanes, for `met` of one.
    struct Columns {
        alignas(64) float dx[lanes], dy[lanes], dz[lanes], px[lanes], py[lanes], pz[lanes],
            lack[lanes], start[lanes], limit[lanes];
    };
    HWY_INLINE void store_all(Columns& to) const {
        store(dx_, to.dx);
        store(dy_, to.dy);
        store(dz_, to.dz);
        store(px_, to.px);
        store(py_, to.py);
        store(pz_, to.pz);
        store(lack_, to.lack);
        store(start_, to.start);
        store_limit(to);
    }
    HWY_INLINE void store_limit(Columns& to) const { store(limit_, to.limit); }

    /// A bit for each sphere of a group, by the same formulas.
    static HWY_INLINE std::uint32_t met(const Group& group, const Columns& rays, std::size_t lane) {
        using Tag = hn::CappedTag<float, Group::size>;
        constexpr Tag tag;
        constexpr std::size_t step = hn::MaxLanes(tag);
        const auto of_ray = [&](const float* column)
                                HWY_ATTR { return hn::Set(Tag{}, column[lane]); };
        const auto dx = of_ray(rays.dx), dy = of_ray(rays.dy), dz = of_ray(rays.dz),
                   px = of_ray(rays.px), py = of_ray(rays.py), pz = of_ray(rays.pz);
        const auto sum = [](auto x, auto y, auto z) HWY_ATTR { return hn::Add(hn::Add(x, y), z); };
        std::uint32_t result = 0;
        for (std::size_t part = 0; part < Group::size; part += step) {
            const auto of_spheres = [&](const auto& column)
                                        HWY_ATTR { return hn::LoadU(Tag{}, &column[part]); };
            const auto x = of_spheres(group.spheres.x), y = of_spheres(group.spheres.y),
                       z = of_spheres(group.spheres.z), r = of_spheres(group.spheres.reach);
            const auto along = sum(hn::Mul(x, dx), hn::Mul(y, dy), hn::Mul(z, dz));
            const auto beside = sum(hn::Mul(x, px), hn::Mul(y, py), hn::Mul(z, pz));
            const auto room = sum(hn::Sub(of_spheres(group.spheres.power), of_ray(rays.lack)),
                                  hn::Add(beside, beside), hn::Mul(along, along));
            const auto hit = hn::And(hn::Lt(hn::Zero(tag), room),
                                     hn::And(hn::Lt(of_ray(rays.start), hn::Add(along, r)),
                                             hn::Lt(hn::Sub(along, r), of_ray(rays.limit))));
            result |= std::uint32_t(bits_of_eight(hit)) << part;
        }
        return result;
    }

private:
    static constexpr double far_away = 1e30;  // and yet a number in single precision

    F per_reach_, margin_, along_;
    S dx_, dy_, dz_, px_, py_, pz_, lack_, start_, limit_;
};

/// Small spheres are met by few rays each: lane by lane, eight spheres at once. Draws `nearest`
/// nearer where one of them is a true crossing.
HWY_INLINE void Kernel::find_small_spheres(Batch& batch, Findings& found) {
    using Stack = RayStack;
    const Rays& rays = batch.rays;
    M named = !(batch.sphere_contacts == U(0));
    for (int w = 0; w < program_.words; ++w)
        named = named | shares(batch.inside.word[w], U(group_bits_[w]));
    named = named & rays.active;
    const Passing middle(rays, program_.groups_middle);
    const M near_all =
        rays.active & middle.meet(program_, rays, program_.groups_reach, found.nearest.t);
    if (!any(named | near_all)) return;

    // The rays are still on the stack, one by one.
    const auto number = [&](Stack::Field field) { return (*batch.stack)[field] + batch.base; };
    const auto word = [&](int field) {
        return batch.stack->word(Stack::Field(field)) + batch.base;
    };
    const double *const ox = number(Stack::ox), *const oy = number(Stack::oy),
                        *const oz = number(Stack::oz), *const dx = number(Stack::dx),
                        *const dy = number(Stack::dy), *const dz = number(Stack::dz);
    const std::uint64_t* const code = word(Stack::code);
    const std::uint64_t* const sphere_contacts = word(Stack::sphere_contacts);
    const std::uint64_t* inside[list_words];
    for (int w = 0; w < program_.words; ++w) inside[w] = word(Stack::inside + w);
    Doubles near(found.nearest.t), first, second, ends;  // the last three of near spheres
    std::uint32_t doubtful = 0, drawn = 0, all_drawn = 0;

    const auto offer = [&](std::size_t lane, int rank, bool is_inside, bool has_contact) {
        const Member& member = program_.members[std::size_t(rank)];
        SphereStretch stretch{};
        bool doubt = false;
        const geom::Vec3 origin{ox[lane], oy[lane], oz[lane]};
        const double largest = geom::max_abs(origin);
        const bool met =
            sphere_stretch(program_, origin, {dx[lane], dy[lane], dz[lane]}, member.center,
                           member.radius, is_inside, has_contact, largest,
                           std::max(RayCode::birth(code[lane]), largest), stretch, doubt);
        if (doubt) doubtful |= 1u << lane;
        if (!met) return;
        stretch.rank = rank;
        SphereStretches& list = batch.spheres[lane];
        if (!(batch.near_spheres >> lane & 1u)) {
            batch.near_spheres |= 1u << lane;
            list.size = 0;
            first[lane] = second[lane] = ends[lane] = infinity;
        }
        if (list.size == SphereStretches::most) {
            doubtful |= 1u << lane;
            return;
        }
        list.at[list.size++] = stretch;
        std::uint64_t hidden = 0;
        for (int w = 0; w < program_.words; ++w)
            hidden |= inside[w][lane] & member.stronger[std::size_t(w)];
        const double t = is_inside ? stretch.out : stretch.in;
        second[lane] = std::min(second[lane], std::max(first[lane], t));
        first[lane] = std::min(first[lane], t);
        if (hidden != 0 || !(t < near[lane])) return;
        drawn |= 1u << lane;
        near[lane] = t;
        ends[lane] = is_inside ? infinity : stretch.out;
        batch.sphere_ranks[lane] = double(rank);
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
    GroupTest::Columns columns;
    const auto try_group = [&](const Group& group, std::size_t lane) HWY_ATTR {
        for (std::uint32_t hit = GroupTest::met(group, columns, lane); hit; hit &= hit - 1) {
            const int rank = group.rank[std::size_t(__builtin_ctz(hit))];
            if (inside[rank / 64][lane] >> (rank % 64) & 1u) continue;
            if (int(sphere_contacts[lane] & 0xffffffffu) == rank + 1 ||
                int(sphere_contacts[lane] >> 32) == rank + 1)
                continue;
            offer(lane, rank, false, false);
        }
    };
    F nearest = drawn ? load(near.at) : found.nearest.t;
    GroupTest test(program_, rays, middle, nearest);
    test.store_all(columns);
    const std::uint32_t lanes_near = bits(near_all);
    for (const Group& group : program_.groups) {
        all_drawn |= drawn;
        drawn = 0;
        for_each(lanes_near & test.met(group),
                 [&](std::size_t lane) HWY_ATTR { try_group(group, lane); });
        if (!drawn) continue;
        nearest = load(near.at);
        test.come_near(nearest);
        test.store_limit(columns);
    }
    batch.unsure = batch.unsure | mask_of(doubtful);
    if (batch.near_spheres == 0) return;
    const M have = mask_of(batch.near_spheres);
    const auto of_spheres = [&](const Doubles& numbers)
                                HWY_ATTR { return select(have, load(numbers.at), F(infinity)); };
    const F nearest_sphere = of_spheres(first);
    found.second = min(min(found.second, of_spheres(second)), max(found.first, nearest_sphere));
    found.first = min(found.first, nearest_sphere);
    found.second = min(found.second, of_spheres(ends));
    if (all_drawn |= drawn; all_drawn != 0) {
        const M which = mask_of(all_drawn);
        found.nearest.t = nearest;
        found.nearest.index = select(which, U(is_small_sphere), found.nearest.index);
        found.nearest.face = but_not(which, found.nearest.face);
    }
}

/// The lanes whose events small spheres own.
HWY_INLINE void Kernel::add_small_spheres(const Batch& batch, M met, Round& round,
                                          F& owner_magnitude) const {
    const M on_some = met & (batch.owner_index == U(is_small_sphere));
    if (!any(on_some)) return;
    const Doubles& ranks = batch.sphere_ranks;
    Doubles x, y, z, radius, inverse, magnitude;
    for_each(on_some, [&](std::size_t lane) {
        const int rank = int(ranks[lane]);
        const Member& member = program_.members[std::size_t(rank)];
        x[lane] = member.center.x;
        y[lane] = member.center.y;
        z[lane] = member.center.z;
        radius[lane] = member.radius;
        inverse[lane] = member.inverse_radius;
        magnitude[lane] = magnitudes_[std::size_t(rank)];
    });
    round.which = round.which | on_some;
    round.center = select(on_some, F3{load(x.at), load(y.at), load(z.at)}, round.center);
    round.radius = select(on_some, load(radius.at), round.radius);
    round.inverse_radius = select(on_some, load(inverse.at), round.inverse_radius);
    if (!program_.one_tolerance)
        owner_magnitude = select(on_some, load(magnitude.at), owner_magnitude);
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
