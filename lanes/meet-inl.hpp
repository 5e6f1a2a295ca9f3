// First stage of a step: where each solid's stretches of the rays lie, and the nearest true
// crossing.

#if defined(MENISCUS_LANES_MEET) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_MEET
#undef MENISCUS_LANES_MEET
#else
#define MENISCUS_LANES_MEET
#endif

#include "lanes/kernel-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

/// Where each solid's stretches of the rays lie, and the nearest crossing that is true.
inline void Kernel::find_stretches(Batch& batch) {
    batch.nearest = F(infinity);
    batch.pivot_magnitude = F(0.0);
    batch.unsure = no_lanes();
    for (std::size_t i = 0; i < program_.solids.size(); ++i) {
        if (!is_foreign(program_.solids[i].kind)) meet(batch, i);
    }
    if (!program_.groups.empty()) find_small_spheres(batch);
    // The host is asked last, when it is known how near a crossing must be.
    if (!program_.has_foreign) return;
    for (std::size_t i = 0; i < program_.solids.size(); ++i) {
        if (is_foreign(program_.solids[i].kind)) meet(batch, i);
    }
}

/// What solid `i` has to say about the rays.
HWY_INLINE void Kernel::meet(Batch& batch, std::size_t i) {
    const Rays& rays = batch.rays;
    const Solid& solid = program_.solids[i];
    const std::size_t word = std::size_t(solid.place / 64);
    const M listed = shares(batch.inside.word[word], U(1ull << (solid.place % 64)));
    const U contact = contact_of(rays, int(i));
    const M has_contact = shares(contact, U(15));
    const M in_shape = solid.inverse ? !listed : listed;
    // What stands in no list is judged by place, but where the ray was born on it.
    const bool is_member = solid.rank >= 0;
    const std::size_t first = 2 * i, end = first + (has_two_stretches(solid.kind) ? 2 : 1);
    Stretch* const stretches = batch.stretches;

    M unsure = no_lanes();
    batch.is_near[i] = true;
    if (solid.kind == Kind::lathe) {
        lathe_stretches(program_, solid, rays, is_member ? !no_lanes() : has_contact, in_shape,
                        stretches[first], stretches[first + 1], unsure);
    } else if (solid.kind == Kind::other) {
        const M known = is_member ? !no_lanes() : has_contact;
        const LatheCrossings found = ask_crossings(
            batch, solid,
            near_foreign(solid, rays, (known & in_shape) | has_contact, batch.nearest), unsure);
        settle(program_, solid, rays, known, in_shape, found, stretches[first],
               stretches[first + 1], unsure);
    } else {
        Span span;
        switch (solid.kind) {
            case Kind::sphere:
                span = sphere_span(solid, rays, contact);
                break;
            case Kind::box:
                span = box_span(solid, rays, contact);
                break;
            case Kind::cylinder:
                span = cylinder_span(solid, rays, contact);
                break;
            case Kind::half_space:
                span = half_space_span(solid, rays, contact);
                break;
            default: {
                const M named = is_member ? in_shape | has_contact : has_contact;
                span = ask_span(batch, solid, contact,
                                near_foreign(solid, rays, named, batch.nearest));
            }
        }
        const M begins_inside =
            is_member ? in_shape
                      : select_mask(has_contact, in_shape,
                                    span.hit & (span.t0 < F(0.0)) & (F(0.0) < span.t1));
        stretches[first] = resolve(program_, solid, rays, span, begins_inside, has_contact, unsure);
    }
    if (!(solid.to_camera && solid.to_mirrors && solid.to_lights)) {
        M unseen = no_lanes();
        if (batch.is_shadow) {
            if (!solid.to_lights) unseen = !unseen;
        } else {
            if (!solid.to_camera) unseen = !batch.is_mirrored;
            if (!solid.to_mirrors) unseen = unseen | batch.is_mirrored;
        }
        unsure = but_not(unsure, unseen);
        for (std::size_t slot = first; slot < end; ++slot) {
            stretches[slot].in = select(unseen, F(infinity), stretches[slot].in);
            stretches[slot].out = select(unseen, F(infinity), stretches[slot].out);
        }
    }
    batch.unsure = batch.unsure | unsure;
    M near = stretches[first].in < F(infinity);
    if (end > first + 1) near = near | (stretches[first + 1].in < F(infinity));
    batch.is_near[i] = any(near);
    if (!batch.is_near[i]) return;

    // To enter and to leave are true crossings where nothing stronger is around.
    M hidden = no_lanes();
    for (std::size_t w = word; is_member && w < std::size_t(program_.words); ++w)
        hidden = hidden | shares(batch.inside.word[w], U(solid.stronger[w]));
    for (std::size_t slot = first; slot < end; ++slot) {
        const Stretch& stretch = stretches[slot];
        const F end_of_way = select(stretch.in == F(-infinity), stretch.out, stretch.in);
        const F crossing = is_member ? select(hidden, F(infinity), end_of_way) : end_of_way;
        if (!program_.one_tolerance)
            batch.pivot_magnitude =
                select(crossing < batch.nearest, F(solid.magnitude), batch.pivot_magnitude);
        batch.nearest = min(crossing, batch.nearest);
    }
}

/// What the host's own convex solids leave of the lines of `which`.
HWY_INLINE Span Kernel::ask_span(const Batch& batch, const Solid& solid, U contact, M which) {
    Doubles t0{F(infinity)}, t1{F(-infinity)}, face0{F(-1.0)}, face1{F(-1.0)};
    std::uint32_t hit = 0;
    if (any(which)) {
        const Words contacts(contact);
        const Line3 lines(batch.rays);
        for_each(which, [&](std::size_t lane) {
            const geom::Interval interval =
                host_.interval(solid, lines.ray(lane), geom::Face(contacts[lane]) - 1);
            t0[lane] = interval.t0;
            t1[lane] = interval.t1;
            face0[lane] = double(interval.face0);
            face1[lane] = double(interval.face1);
            if (interval.hit) hit |= 1u << lane;
        });
    }
    return {load(t0.at), load(t1.at), load(face0.at), load(face1.at), mask_of(hit)};
}

/// The crossings of the lines of `which` with one of the host's own solids.
HWY_INLINE LatheCrossings Kernel::ask_crossings(const Batch& batch, const Solid& solid, M which,
                                                M& unsure) {
    Doubles t[most_lathe_crossings], face[most_lathe_crossings], slope[most_lathe_crossings];
    for (int k = 0; k < most_lathe_crossings; ++k) {
        t[k] = Doubles(F(infinity));
        face[k] = slope[k] = Doubles(F(0.0));
    }
    std::uint32_t too_many = 0;
    if (any(which)) {
        const Line3 lines(batch.rays);
        for_each(which, [&](std::size_t lane) {
            Met met[most_lathe_crossings];
            const int count = host_.crossings(solid, lines.ray(lane), met);
            if (count < 0) too_many |= 1u << lane;
            for (int k = 0; k < count; ++k) {
                t[k][lane] = met[k].t;
                face[k][lane] = double(met[k].face);
                slope[k][lane] = met[k].slope;
            }
        });
    }
    unsure = unsure | mask_of(too_many);
    LatheCrossings found;
    for (int k = 0; k < most_lathe_crossings; ++k) {
        found.t[k] = load(t[k].at);
        found.piece[k] = load(face[k].at);
        found.slope[k] = load(slope[k].at);
    }
    return found;
}

/// Small spheres are met by few rays each: lane by lane, eight spheres at once. Draws `nearest`
/// nearer where one of them is a true crossing.
HWY_INLINE void Kernel::find_small_spheres(Batch& batch) {
    const Rays& rays = batch.rays;
    Words inside[list_words];
    for (int w = 0; w < program_.words; ++w) inside[w] = Words(batch.inside.word[w]);
    const Words sphere_contacts(batch.sphere_contacts);
    const Doubles ox(rays.world.origin.x), oy(rays.world.origin.y), oz(rays.world.origin.z);
    const Doubles dx(rays.world.direction.x), dy(rays.world.direction.y),
        dz(rays.world.direction.z);
    const Doubles largest(rays.largest), birth(rays.birth);
    Doubles near(batch.nearest), pivot(batch.pivot_magnitude);
    std::uint32_t doubtful = 0;
    const std::uint32_t active = bits(rays.active);

    const auto offer = [&](std::size_t lane, int rank, bool is_inside, bool has_contact) {
        const Member& member = program_.members[std::size_t(rank)];
        SphereStretch stretch{};
        bool doubt = false;
        const bool met = sphere_stretch(
            program_, {ox[lane], oy[lane], oz[lane]}, {dx[lane], dy[lane], dz[lane]}, member.center,
            member.radius, is_inside, has_contact, largest[lane], birth[lane], stretch, doubt);
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
            pivot[lane] = magnitudes_[std::size_t(rank)];
        }
    };
    // Those that the list or a contact names, first: no box can hide them.
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        if (!(active >> lane & 1u)) continue;
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
    }
    for (const Group& group : program_.groups) {
        // Missed, behind, or beyond what is nearest: by the group's sphere.
        const F3 e = rays.world.origin - F3(group.center);
        const F b = dot(e, rays.world.direction);
        const F3 f = e - b * rays.world.direction;
        const F room = F(group.radius * group.radius) - dot(f, f);
        const F bound = load(near.at) * F(1.0 + 1e-6) + F(1e-6) * (rays.largest + F(group.radius));
        const M met = rays.active & (F(0.0) < room) & ((b < F(0.0)) | (b * b < room)) &
                      ((-b < bound) | ((b + bound) * (b + bound) < room));
        for (std::uint32_t left = bits(met); left; left &= left - 1) {
            const std::size_t lane = std::size_t(__builtin_ctz(left));
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
                const auto space =
                    hn::Sub(hn::Mul(r, r),
                            hn::Add(hn::Add(hn::Mul(fx, fx), hn::Mul(fy, fy)), hn::Mul(fz, fz)));
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
        }
    }
    batch.nearest = load(near.at);
    batch.pivot_magnitude = load(pivot.at);
    batch.unsure = batch.unsure | mask_of(doubtful);
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
