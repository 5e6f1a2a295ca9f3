// One step of the kernel: the rays on top of the stack go to where their medium next changes, and
// what they split into is pushed. docs/kernels.md walks through it.

#if defined(MENISCUS_LANES_STEP) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_STEP
#undef MENISCUS_LANES_STEP
#else
#define MENISCUS_LANES_STEP
#endif

#include <cmath>

#include "lanes/batch-inl.hpp"
#include "lanes/chance.hpp"
#include "lanes/faces-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

class Kernel {
public:
    Kernel(const Program& program, Host& host, RayStack& stack, std::int64_t* sums)
        : program_(program), host_(host), stack_(stack), sums_(sums) {
        for (std::size_t rank = 0; rank < program.members.size(); ++rank) {
            const Member& member = program.members[rank];
            if (member.in_group) group_bits_[rank / 64] |= 1ull << (rank % 64);
            const geom::Vec3& c = member.center;
            magnitudes_.push_back(std::max({std::abs(c.x), std::abs(c.y), std::abs(c.z)}) +
                                  member.radius);
        }
    }

    Counts run() {
        while (true) {
            if (stack_.size() < lanes) host_.more_rays(stack_, lanes - stack_.size());
            if (stack_.size() == 0) return counts_;
            step();
        }
    }

private:
    void step();
    HWY_INLINE void take(Batch& batch);
    HWY_INLINE void find_stretches(Batch& batch);
    HWY_INLINE void meet(Batch& batch, std::size_t solid);
    HWY_INLINE Span ask_span(const Batch& batch, const Solid& solid, U contact, M which);
    HWY_INLINE LatheCrossings ask_crossings(const Batch& batch, const Solid& solid, M which,
                                            M& unsure);
    HWY_INLINE void find_small_spheres(Batch& batch);
    HWY_INLINE void make_lists(Batch& batch, Top& before, Top& after);
    HWY_INLINE void list_small_spheres(Batch& batch, F pivot, F reach, M& torn, Top& before,
                                       Top& after);
    HWY_INLINE void hand_over(Batch& batch);
    HWY_INLINE void attenuate(Batch& batch, M which, const Top& before);
    HWY_INLINE void arrive(const Batch& batch, M gone, const Top& before);
    HWY_INLINE FacePoint ask_face(const Solid& solid, M which, const F3& point, F face);
    HWY_INLINE void put_on_small_spheres(M which, F owner, F3& point, F3& normal,
                                         F& owner_magnitude) const;
    HWY_INLINE void dress(const Batch& batch, M which, M by_surface, F3 point, F3 normal, F owner,
                          F face, F magnitude, F level, const Top& before, const Top& after);
    HWY_INLINE void choose(M splits, F reflectance, F transmittance, F weight, U key, M& reflects,
                           M& transmits, F& reflect_factor, F& transmit_factor, F& reflect_weight,
                           F& transmit_weight, U& reflect_key, U& transmit_key) const;
    WaitingRay waiting(std::size_t at);
    void add_light(std::uint64_t code, const geom::Vec3& light) {
        std::int64_t* sum = sums_ + 4 * (code & RayCode::pixel_mask);
        for (int i = 0; i < 3; ++i) sum[i] += std::int64_t(std::llrint(light[i] * program_.units));
        ++sum[3];
    }

    const Program& program_;
    Host& host_;
    RayStack& stack_;
    std::int64_t* sums_;
    Counts counts_;
    std::vector<double> magnitudes_;             // of grouped spheres, by rank
    std::uint64_t group_bits_[list_words] = {};  // their places
};

/// The face number of a contact, in its place in the word of all contacts; 15: some face beyond the
/// numbers that fit.
HWY_INLINE U contact_word(F face, int index) {
    const F with_exponent = min(face + F(1.0), F(15.0)) + F(0x1p52);
    return shift_left(
        U(hn::BitCast(integers, with_exponent.a), hn::BitCast(integers, with_exponent.b)) & U(15),
        4 * index);
}

/// Takes the rays on top of the stack.
HWY_INLINE void Kernel::take(Batch& batch) {
    using Stack = RayStack;
    batch.size = std::min(stack_.size(), lanes);
    batch.base = stack_.size() - batch.size;
    stack_.resize(batch.base);
    const auto numbers = [&](Stack::Field field) { return load(stack_[field] + batch.base); };
    const auto words = [&](Stack::Field field) { return load(stack_.word(field) + batch.base); };

    Rays& rays = batch.rays;
    rays.active = first_lanes(batch.size);
    rays.world.origin = {numbers(Stack::ox), numbers(Stack::oy), numbers(Stack::oz)};
    rays.world.direction = {numbers(Stack::dx), numbers(Stack::dy), numbers(Stack::dz)};
    rays.world.squared_length = F(1.0);
    rays.t_max = program_.has_lights ? numbers(Stack::t_max) : F(infinity);
    rays.largest =
        max(max(abs(rays.world.origin.x), abs(rays.world.origin.y)), abs(rays.world.origin.z));
    rays.birth = max(numbers(Stack::birth), rays.largest);
    rays.contacts = words(Stack::contacts);
    batch.throughput = {numbers(Stack::red), numbers(Stack::green), numbers(Stack::blue)};
    batch.weight = numbers(Stack::weight);
    batch.way_before = program_.attenuates ? numbers(Stack::way) : F(0.0);
    batch.top = numbers(Stack::top);
    batch.code = words(Stack::code);
    batch.key = program_.uses_keys ? words(Stack::key) : U(0);
    batch.inside.low = words(Stack::inside0);
    batch.inside.high = program_.two_words ? words(Stack::inside1) : U(0);
    batch.sphere_contacts = program_.groups.empty() ? U(0) : words(Stack::sphere_contacts);
    batch.is_shadow =
        program_.has_lights ? !((batch.code & U(RayCode::shadow)) == U(0)) : no_lanes();
    batch.is_mirrored = but_not(!((batch.code & U(RayCode::reflected)) == U(0)), batch.is_shadow);
}

/// Where each solid's stretches of the rays lie, and the nearest crossing that is true.
HWY_INLINE void Kernel::find_stretches(Batch& batch) {
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
    const U bit(1ull << (solid.place % 64));
    const M listed = !(((solid.place < 64 ? batch.inside.low : batch.inside.high) & bit) == U(0));
    const U contact = contact_of(rays, int(i));
    const M has_contact = !(contact == U(0));
    const M in_shape = solid.inverse ? !listed : listed;
    const M known = solid.rank >= 0 ? !no_lanes() : has_contact;
    const std::size_t first = 2 * i, end = first + (has_two_stretches(solid.kind) ? 2 : 1);
    Stretch* const stretches = batch.stretches;

    M unsure = no_lanes();
    batch.is_near[i] = true;
    if (solid.kind == Kind::lathe) {
        lathe_stretches(program_, solid, rays, known, in_shape, stretches[first],
                        stretches[first + 1], unsure);
    } else if (solid.kind == Kind::other) {
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
            default:
                span = ask_span(
                    batch, solid, contact,
                    near_foreign(solid, rays, (known & in_shape) | has_contact, batch.nearest));
        }
        batch.is_near[i] = any(rays.active & (span.hit | (known & in_shape)));
        if (!batch.is_near[i] && !solid.inverse) return;
        // What stands in no list is judged by place, but where the ray was born on it.
        const M begins_inside =
            select_mask(known, in_shape, span.hit & (span.t0 < F(0.0)) & (F(0.0) < span.t1));
        stretches[first] = resolve(program_, solid, rays, span, begins_inside, has_contact, unsure);
    }
    if (!(solid.to_camera && solid.to_mirrors && solid.to_lights)) {
        M unseen = no_lanes();
        if (!solid.to_camera) unseen = !(batch.is_shadow | batch.is_mirrored);
        if (!solid.to_mirrors) unseen = unseen | batch.is_mirrored;
        if (!solid.to_lights) unseen = unseen | batch.is_shadow;
        unsure = but_not(unsure, unseen);
        for (std::size_t slot = first; slot < end; ++slot) {
            stretches[slot].in = select(unseen, F(infinity), stretches[slot].in);
            stretches[slot].out = select(unseen, F(infinity), stretches[slot].out);
        }
    }
    batch.unsure = batch.unsure | unsure;
    batch.is_near[i] = any(rays.active & ((stretches[first].in < F(infinity)) |
                                          (stretches[end - 1].in < F(infinity))));
    const F rank{double(solid.rank)};
    const M is_top = batch.top == rank, is_weaker = batch.top < rank;
    for (std::size_t slot = first; slot < end; ++slot) {
        const Stretch& stretch = stretches[slot];
        const M leaves_shape = stretch.in == F(-infinity);
        F crossing = select(leaves_shape, stretch.out, stretch.in);
        if (solid.rank >= 0) {
            // To enter is true for what is stronger than the top, to leave for the top.
            const M is_true = solid.inverse ? select_mask(leaves_shape, is_weaker, is_top)
                                            : select_mask(leaves_shape, is_top, is_weaker);
            crossing = select(is_true, crossing, F(infinity));
        }
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
    const Words inside[list_words] = {Words(batch.inside.low), Words(batch.inside.high)};
    const Words sphere_contacts(batch.sphere_contacts);
    const Doubles top(batch.top);
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
        if (list.size == SphereStretches::most) {
            doubtful |= 1u << lane;
            return;
        }
        list.at[list.size++] = stretch;
        const double candidate = is_inside ? (top[lane] == rank ? stretch.out : infinity)
                                 : double(rank) > top[lane] ? stretch.in
                                                            : infinity;
        if (candidate < near[lane]) {
            near[lane] = candidate;
            pivot[lane] = magnitudes_[std::size_t(rank)];
        }
    };
    // Those that the list or a contact names, first: no box can hide them.
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        batch.spheres[lane].size = 0;
        if (!(active >> lane & 1u)) continue;
        const int contact[2] = {int(sphere_contacts[lane] & 0xffffffffu) - 1,
                                int(sphere_contacts[lane] >> 32) - 1};
        for (int w = 0; w < list_words; ++w) {
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

/// What coincides with the nearest true crossing, and the lists just before and just after.
HWY_INLINE void Kernel::make_lists(Batch& batch, Top& before, Top& after) {
    const Rays& rays = batch.rays;
    batch.met = rays.active & (batch.nearest < F(infinity)) & (batch.nearest <= rays.t_max);
    const F t = select(batch.met, batch.nearest, min(rays.t_max, F(1e300)));
    batch.t = t;
    batch.before = batch.after = {U(0), U(0)};
    batch.contacts = U(0);
    batch.surface = F(double(no_rank));
    batch.surface_face = F(0.0);
    batch.false_crossings = F(0.0);
    const F units(program_.tolerance_units * unit_roundoff), least(program_.contact_tolerance);
    const F pivot = program_.one_tolerance ? F(program_.largest_magnitude) : batch.pivot_magnitude;
    const F far = rays.largest + t;
    const F reach = max(F(1e-7) * (far + pivot), F(100.0) * least);
    const F common = max(units * (far + pivot), least);
    M torn = no_lanes();
    for (std::size_t i = 0; i < program_.solids.size(); ++i) {
        const Solid& solid = program_.solids[i];
        if (!batch.is_near[i] && !solid.inverse) continue;  // nowhere before, nowhere after
        const F tolerance = program_.one_tolerance
                                ? common
                                : max(units * (far + max(pivot, F(solid.magnitude))), least);
        const F low = t - tolerance, high = t + tolerance;
        M is_before = no_lanes(), is_after = is_before, once = is_before;
        F face(0.0);
        for (std::size_t part = 0; part < (has_two_stretches(solid.kind) ? 2 : 1); ++part) {
            const Stretch& stretch = batch.stretches[2 * i + part];
            const M entered = stretch.in < low, entered_after = stretch.in <= high;
            const M left = stretch.out < low, left_after = stretch.out <= high;
            const M enters = entered ^ entered_after, leaves = left ^ left_after;
            torn = torn | (enters ^ (abs(stretch.in - t) <= reach)) |
                   (leaves ^ (abs(stretch.out - t) <= reach));
            is_before = is_before | but_not(entered, left);
            is_after = is_after | but_not(entered_after, left_after);
            once = once ^ enters ^ leaves;
            const M fresh = but_not(entered, stretch.in == F(-infinity));
            if (any(fresh | left))
                batch.false_crossings =
                    batch.false_crossings + only(fresh, F(1.0)) + only(left, F(1.0));
            if (solid.kind != Kind::sphere && solid.kind != Kind::half_space)
                face = select(enters, stretch.face_in, select(leaves, stretch.face_out, face));
        }
        batch.contacts = batch.contacts | only(once, contact_word(face, int(i)));
        if (solid.inverse) {
            is_before = !is_before;
            is_after = !is_after;
        }
        const U bit(1ull << (solid.place % 64));
        if (solid.place < 64) {
            batch.before.low = batch.before.low | only(is_before, bit);
            batch.after.low = batch.after.low | only(is_after, bit);
        } else {
            batch.before.high = batch.before.high | only(is_before, bit);
            batch.after.high = batch.after.high | only(is_after, bit);
        }
        if (solid.rank < 0) {
            batch.surface = select(once, F(double(i)), batch.surface);
            batch.surface_face = select(once, face, batch.surface_face);
            continue;
        }
        // Solids stand in the order of their ranks.
        const Member& member = program_.members[std::size_t(solid.rank)];
        before.cover(is_before, solid.rank, member);
        after.cover(is_after, solid.rank, member);
        before.face = select(is_before, face, before.face);
        after.face = select(is_after, face, after.face);
    }
    if (!program_.groups.empty()) list_small_spheres(batch, pivot, reach, torn, before, after);
    batch.unsure = rays.active & (batch.unsure | (batch.met & torn));
}

/// The same for small spheres, lane by lane.
HWY_INLINE void Kernel::list_small_spheres(Batch& batch, F pivot, F reach, M& torn, Top& before,
                                           Top& after) {
    const Doubles at(batch.t), margin(reach), largest(batch.rays.largest), pivots(pivot);
    std::uint32_t doubtful = 0, covered_before = 0, covered_after = 0;
    Doubles rank_before(before.rank), rank_after(after.rank), skipped(batch.false_crossings);
    Words low_before(batch.before.low), high_before(batch.before.high), low_after(batch.after.low),
        high_after(batch.after.high);
    batch.sphere_contacts_after = Words(U(0));
    for_each(batch.rays.active, [&](std::size_t lane) {
        const SphereStretches& list = batch.spheres[lane];
        int contacts = 0;
        for (int k = 0; k < list.size; ++k) {
            const SphereStretch& stretch = list.at[k];
            const double tolerance =
                std::max(program_.tolerance_units * unit_roundoff *
                             (largest[lane] + at[lane] +
                              std::max(pivots[lane], magnitudes_[std::size_t(stretch.rank)])),
                         program_.contact_tolerance);
            const double low = at[lane] - tolerance, high = at[lane] + tolerance;
            const bool entered = stretch.in < low, entered_after = stretch.in <= high;
            const bool left = stretch.out < low, left_after = stretch.out <= high;
            const bool enters = entered != entered_after, leaves = left != left_after;
            if (enters != (std::abs(stretch.in - at[lane]) <= margin[lane]) ||
                leaves != (std::abs(stretch.out - at[lane]) <= margin[lane]))
                doubtful |= 1u << lane;
            const std::uint64_t bit = 1ull << (stretch.rank % 64);
            if (entered && !left) {
                (stretch.rank < 64 ? low_before : high_before)[lane] |= bit;
                if (rank_before[lane] < stretch.rank) {
                    rank_before[lane] = stretch.rank;
                    covered_before |= 1u << lane;
                }
            }
            if (entered_after && !left_after) {
                (stretch.rank < 64 ? low_after : high_after)[lane] |= bit;
                if (rank_after[lane] < stretch.rank) {
                    rank_after[lane] = stretch.rank;
                    covered_after |= 1u << lane;
                }
            }
            if (enters != leaves) {
                if (contacts == 2) {
                    doubtful |= 1u << lane;
                } else {
                    batch.sphere_contacts_after[lane] |= std::uint64_t(stretch.rank + 1)
                                                         << (32 * contacts++);
                }
            }
            skipped[lane] += (entered && stretch.in > -infinity) + left;
        }
    });
    torn = torn | mask_of(doubtful);
    batch.false_crossings = load(skipped.at);
    batch.before = {load(low_before.at), load(high_before.at)};
    batch.after = {load(low_after.at), load(high_after.at)};
    const auto cover = [&](std::uint32_t which, const Doubles& ranks, Top& top) {
        if (which == 0) return;
        Doubles iors(top.ior), media(top.medium);
        std::uint32_t dressed = bits(top.dressed), attenuates = bits(top.attenuates);
        for (std::uint32_t left = which; left; left &= left - 1) {
            const std::size_t lane = std::size_t(__builtin_ctz(left));
            const Member& member = program_.members[std::size_t(ranks[lane])];
            iors[lane] = member.ior;
            media[lane] = double(member.medium);
            const std::uint32_t bit = 1u << lane;
            dressed = member.clear ? dressed & ~bit : dressed | bit;
            attenuates = member.attenuates ? attenuates | bit : attenuates & ~bit;
        }
        top.rank = load(ranks.at);
        top.ior = load(iors.at);
        top.medium = load(media.at);
        top.dressed = mask_of(dressed);
        top.attenuates = mask_of(attenuates);
    };
    cover(covered_before, rank_before, before);
    cover(covered_after, rank_after, after);
}

/// What is too close to call is followed by the host.
HWY_INLINE void Kernel::hand_over(Batch& batch) {
    for_each(batch.unsure, [&](std::size_t lane) {
        const WaitingRay ray = waiting(batch.base + lane);
        add_light(ray.code, host_.follow(ray));
        --counts_.segments;
        ++counts_.handed_over;
    });
    batch.rays.active = but_not(batch.rays.active, batch.unsure);
    batch.met = but_not(batch.met, batch.unsure);
    batch.false_crossings = only(batch.rays.active, batch.false_crossings);
}

/// The medium on the way, up to the event or to the light.
HWY_INLINE void Kernel::attenuate(Batch& batch, M which, const Top& before) {
    Doubles red(batch.throughput.x), green(batch.throughput.y), blue(batch.throughput.z);
    const Doubles way(batch.way_before + batch.t), rank(before.rank);
    const std::uint32_t shadows = bits(batch.is_shadow);
    for_each(which, [&](std::size_t lane) {
        const geom::Vec3 share =
            host_.transmittance(int(rank[lane]), way[lane], (shadows >> lane & 1u) != 0);
        red[lane] *= share.x;
        green[lane] *= share.y;
        blue[lane] *= share.z;
    });
    batch.throughput = {load(red.at), load(green.at), load(blue.at)};
}

/// Light that arrives: of the sky, and of lights that nothing hides.
HWY_INLINE void Kernel::arrive(const Batch& batch, M gone, const Top& before) {
    const M plain =
        gone & (batch.is_shadow | (program_.constant_sky ? before.rank < F(0.0) : no_lanes()));
    const F3& light = batch.throughput;
    const F3 sky(program_.sky);
    const F units(program_.units);
    const Doubles red(units * select(batch.is_shadow, light.x, light.x * sky.x)),
        green(units * select(batch.is_shadow, light.y, light.y * sky.y)),
        blue(units * select(batch.is_shadow, light.z, light.z * sky.z));
    const Words codes(batch.code);
    for_each(plain, [&](std::size_t lane) {
        std::int64_t* sum = sums_ + 4 * (codes[lane] & RayCode::pixel_mask);
        sum[0] += std::int64_t(std::llrint(red[lane]));
        sum[1] += std::int64_t(std::llrint(green[lane]));
        sum[2] += std::int64_t(std::llrint(blue[lane]));
        ++sum[3];
    });
    const M other = but_not(gone, plain);
    if (!any(other)) return;
    const Doubles dx(batch.rays.world.direction.x), dy(batch.rays.world.direction.y),
        dz(batch.rays.world.direction.z), rank(before.rank), r(light.x), g(light.y), b(light.z);
    for_each(other, [&](std::size_t lane) {
        const geom::Vec3 seen = host_.sky({dx[lane], dy[lane], dz[lane]}, int(rank[lane]));
        add_light(codes[lane], {r[lane] * seen.x, g[lane] * seen.y, b[lane] * seen.z});
    });
}

/// Points on a face of one of the host's own solids.
HWY_INLINE FacePoint Kernel::ask_face(const Solid& solid, M which, const F3& point, F face) {
    Doubles x{point.x}, y{point.y}, z{point.z}, nx{F(0.0)}, ny{F(1.0)}, nz{F(0.0)};
    const Doubles faces(face);
    for_each(which, [&](std::size_t lane) {
        geom::Vec3 p{x[lane], y[lane], z[lane]};
        const geom::Vec3 n = host_.put_on_face(solid, geom::Face(faces[lane]), p);
        x[lane] = p.x;
        y[lane] = p.y;
        z[lane] = p.z;
        nx[lane] = n.x;
        ny[lane] = n.y;
        nz[lane] = n.z;
    });
    return {{load(x.at), load(y.at), load(z.at)}, {load(nx.at), load(ny.at), load(nz.at)}};
}

/// Points that lie on small spheres, and the normals there.
HWY_INLINE void Kernel::put_on_small_spheres(M which, F owner, F3& point, F3& normal,
                                             F& owner_magnitude) const {
    const Doubles ranks(select(which, owner, F(double(no_rank))));
    Doubles cx, cy, cz, radius;
    std::uint32_t here = 0;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        cx[lane] = cy[lane] = cz[lane] = 0.0;
        radius[lane] = 1.0;
        const int rank = int(ranks[lane]);
        if (rank < 0 || !program_.members[std::size_t(rank)].in_group) continue;
        const Member& member = program_.members[std::size_t(rank)];
        cx[lane] = member.center.x;
        cy[lane] = member.center.y;
        cz[lane] = member.center.z;
        radius[lane] = member.radius;
        here |= 1u << lane;
    }
    if (here) {
        const M mask = mask_of(here);
        const F3 center{load(cx.at), load(cy.at), load(cz.at)};
        const F r = load(radius.at);
        const F3 e = point - center;
        const F distance = sqrt(dot(e, e));
        const F inverse = F(1.0) / distance;
        point = select(mask, point + (r - distance) * inverse * e, point);
        normal = select(mask, inverse * e, normal);
        owner_magnitude = select(mask, max(max(abs(center.x), abs(center.y)), abs(center.z)) + r,
                                 owner_magnitude);
    }
}

/// Surfaces that the host shades.
HWY_INLINE void Kernel::dress(const Batch& batch, M which, M by_surface, F3 point, F3 normal,
                              F owner, F face, F magnitude, F level, const Top& before,
                              const Top& after) {
    const Doubles px(point.x), py(point.y), pz(point.z), nx(normal.x), ny(normal.y), nz(normal.z),
        red(batch.throughput.x), green(batch.throughput.y), blue(batch.throughput.z),
        solids(batch.surface), owners(owner), faces(face), ranks_before(before.rank),
        ranks_after(after.rank), magnitudes(magnitude), levels(level), ways(batch.t),
        ox(batch.rays.world.origin.x), oy(batch.rays.world.origin.y), oz(batch.rays.world.origin.z),
        dx(batch.rays.world.direction.x), dy(batch.rays.world.direction.y),
        dz(batch.rays.world.direction.z), weights(batch.weight), limits(batch.rays.t_max);
    const Words codes(batch.code), keys(batch.key), contacts(batch.contacts),
        before_words[list_words] = {Words(batch.before.low), Words(batch.before.high)},
        after_words[list_words] = {Words(batch.after.low), Words(batch.after.high)};
    const std::uint32_t surfaces = bits(by_surface);
    for_each(which, [&](std::size_t lane) {
        Surface surface;
        surface.ray.origin = {ox[lane], oy[lane], oz[lane]};
        surface.ray.direction = {dx[lane], dy[lane], dz[lane]};
        surface.ray.throughput = {red[lane], green[lane], blue[lane]};
        surface.ray.weight = weights[lane];
        surface.ray.t_max = limits[lane];
        surface.ray.code = codes[lane];
        surface.ray.key = keys[lane];
        surface.t = ways[lane];
        surface.point = {px[lane], py[lane], pz[lane]};
        surface.normal = {nx[lane], ny[lane], nz[lane]};
        surface.is_member = !(surfaces >> lane & 1u);
        surface.part = surface.is_member ? program_.members[std::size_t(owners[lane])].part
                                         : program_.solids[std::size_t(solids[lane])].part;
        surface.face = int(faces[lane]);
        surface.rank_before = int(ranks_before[lane]);
        surface.rank_after = int(ranks_after[lane]);
        for (int w = 0; w < list_words; ++w) {
            surface.before[std::size_t(w)] = before_words[w][lane];
            surface.after[std::size_t(w)] = after_words[w][lane];
        }
        surface.contacts = contacts[lane];
        if (!program_.groups.empty()) surface.sphere_contacts = batch.sphere_contacts_after[lane];
        surface.magnitude = magnitudes[lane];
        surface.level = int(levels[lane]);
        add_light(surface.ray.code, host_.shade(surface, stack_));
    });
}

/// Sampled trees: both branches while the weight is high, then one by chance; rays of very low
/// weight survive by chance (tracer/ray_tree.cpp).
HWY_INLINE void Kernel::choose(M splits, F reflectance, F transmittance, F weight, U key,
                               M& reflects, M& transmits, F& reflect_factor, F& transmit_factor,
                               F& reflect_weight, F& transmit_weight, U& reflect_key,
                               U& transmit_key) const {
    const Doubles r(reflectance), t(transmittance), w(weight);
    Doubles rf(reflect_factor), tf(transmit_factor), rw(reflect_weight), tw(transmit_weight);
    const Words keys(key);
    Words rk, tk;
    std::uint32_t follow_r = bits(reflects), follow_t = bits(transmits);
    const std::uint32_t who = bits(splits);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        rk[lane] = reflected_key(keys[lane]);
        tk[lane] = transmitted_key(keys[lane]);
    }
    for (std::uint32_t left = who; left; left &= left - 1) {
        const std::size_t lane = std::size_t(__builtin_ctz(left));
        const std::uint32_t bit = 1u << lane;
        const Branches branches =
            lanes::choose(follow_r & bit, r[lane], follow_t & bit, t[lane], w[lane], keys[lane]);
        if (!branches.mirror) follow_r &= ~bit;
        if (!branches.through) follow_t &= ~bit;
        rf[lane] *= branches.mirror_gain;
        rw[lane] *= branches.mirror_gain;
        tf[lane] *= branches.through_gain;
        tw[lane] *= branches.through_gain;
        const auto roulette = [&](std::uint32_t& follow, double& factor, double& child_weight,
                                  std::uint64_t child_key) {
            if (!(follow & bit)) return;
            const double gain = survive(child_weight, child_key);
            if (gain == 0.0) follow &= ~bit;
            factor *= gain;
            child_weight *= gain;
        };
        roulette(follow_r, rf[lane], rw[lane], rk[lane]);
        roulette(follow_t, tf[lane], tw[lane], tk[lane]);
    }
    reflects = mask_of(follow_r);
    transmits = mask_of(follow_t);
    reflect_factor = load(rf.at);
    transmit_factor = load(tf.at);
    reflect_weight = load(rw.at);
    transmit_weight = load(tw.at);
    reflect_key = load(rk.at);
    transmit_key = load(tk.at);
}

WaitingRay Kernel::waiting(std::size_t at) {
    using Stack = RayStack;
    WaitingRay ray;
    ray.origin = {stack_[Stack::ox][at], stack_[Stack::oy][at], stack_[Stack::oz][at]};
    ray.direction = {stack_[Stack::dx][at], stack_[Stack::dy][at], stack_[Stack::dz][at]};
    ray.throughput = {stack_[Stack::red][at], stack_[Stack::green][at], stack_[Stack::blue][at]};
    ray.weight = stack_[Stack::weight][at];
    ray.t_max = stack_[Stack::t_max][at];
    ray.birth_magnitude = stack_[Stack::birth][at];
    ray.way_before = stack_[Stack::way][at];
    ray.top = int(stack_[Stack::top][at]);
    ray.code = stack_.word(Stack::code)[at];
    ray.key = stack_.word(Stack::key)[at];
    for (int w = 0; w < list_words; ++w)
        ray.inside[std::size_t(w)] = stack_.word(Stack::Field(Stack::inside0 + w))[at];
    ray.contacts = stack_.word(Stack::contacts)[at];
    ray.sphere_contacts = stack_.word(Stack::sphere_contacts)[at];
    return ray;
}

void Kernel::step() {
    using Stack = RayStack;
    Batch batch;
    take(batch);
    counts_.segments += batch.size;
    find_stretches(batch);
    Top before(program_.outside), after(program_.outside);
    make_lists(batch, before, after);
    if (any(batch.unsure)) hand_over(batch);

    const Rays& rays = batch.rays;
    const F t = batch.t;
    const M met = batch.met;
    if (const M some = rays.active & (F(0.0) < batch.false_crossings); any(some)) {
        const Doubles skipped(batch.false_crossings);
        for_each(some, [&](std::size_t lane) {
            counts_.false_crossings += std::uint64_t(skipped[lane]);
        });
    }
    counts_.true_crossings += count(met);

    const M takes_none = (!((batch.code & U(RayCode::straight)) == U(0))) | batch.is_shadow;
    const U level_word =
        (batch.code & U(RayCode::level_mask)) + select(takes_none, U(0), U(RayCode::one_level));
    const F level = to_double(shift_right(level_word, RayCode::level_shift));
    if (const M deeper = rays.active & (F(double(counts_.deepest_level)) < level); any(deeper)) {
        const Doubles levels(level);
        for_each(deeper, [&](std::size_t lane) {
            counts_.deepest_level = std::max(counts_.deepest_level, int(levels[lane]));
        });
    }

    // What is met: the surface of the stronger of the two solids, or one that is always met.
    const M by_surface = met & (F(0.0) <= batch.surface);
    const M member_met = but_not(met, by_surface);
    const M same = member_met & (before.rank == after.rank);
    const M after_owns = before.rank < after.rank;
    const M clear = but_not(member_met, select_mask(after_owns, after.dressed, before.dressed));
    // Nothing is there: the same solid before and after, or like media under a clear skin.
    const M nothing = same | (clear & (before.medium == after.medium));
    const M glass = but_not(clear, nothing);
    const M dressed = but_not(but_not(met, nothing), glass);
    const M gone = but_not(rays.active, met);
    if (program_.attenuates) {
        const M dims = before.attenuates & (glass | dressed | (gone & batch.is_shadow));
        if (any(dims)) attenuate(batch, dims, before);
    }
    if (any(gone)) arrive(batch, gone, before);
    if (!any(met)) return;

    // The point, put back on its face, and the normal there.
    const F owner = select(by_surface, F(double(no_rank)), max(before.rank, after.rank));
    const F face =
        select(by_surface, batch.surface_face, select(after_owns, after.face, before.face));
    F3 point = rays.world.origin + t * rays.world.direction;
    F3 normal(geom::Vec3{0.0, 1.0, 0.0});
    F owner_magnitude(0.0);
    for (std::size_t i = 0; i < program_.solids.size(); ++i) {
        const Solid& solid = program_.solids[i];
        const M here = solid.rank < 0
                           ? by_surface & (batch.surface == F(double(i)))
                           : but_not(member_met, same) & (owner == F(double(solid.rank)));
        if (!any(here)) continue;
        const FacePoint put = is_foreign(solid.kind) ? ask_face(solid, here, point, face)
                                                     : face_point(solid, point, face);
        point = select(here, put.point, point);
        normal = select(here, solid.inverse ? F(-1.0) * put.normal : put.normal, normal);
        owner_magnitude = select(here, F(solid.magnitude), owner_magnitude);
    }
    if (!program_.groups.empty())
        put_on_small_spheres(but_not(member_met, same), owner, point, normal, owner_magnitude);
    const F magnitude = rays.largest + t + owner_magnitude;

    // Rays that go on.
    stack_.reserve(stack_.size() + 3 * lanes);
    const U sphere_contacts = program_.groups.empty() ? U(0) : load(batch.sphere_contacts_after.at);
    const auto push = [&](M which, const F3& direction, const F3& light, F weight, F t_max, F way,
                          const List& list, F top, U code, U key) HWY_ATTR {
        const Packing packing(bits(which));
        if (packing.count == 0) return;
        const std::size_t at = stack_.size();
        const auto numbers = [&](Stack::Field field, F x)
                                 HWY_ATTR { store(x, packing, stack_[field] + at); };
        const auto words = [&](Stack::Field field, U x)
                               HWY_ATTR { store(x, packing, stack_.word(field) + at); };
        numbers(Stack::ox, point.x);
        numbers(Stack::oy, point.y);
        numbers(Stack::oz, point.z);
        numbers(Stack::dx, direction.x);
        numbers(Stack::dy, direction.y);
        numbers(Stack::dz, direction.z);
        numbers(Stack::red, light.x);
        numbers(Stack::green, light.y);
        numbers(Stack::blue, light.z);
        numbers(Stack::weight, weight);
        numbers(Stack::birth, magnitude);
        numbers(Stack::top, top);
        words(Stack::code, code);
        words(Stack::inside0, list.low);
        words(Stack::contacts, batch.contacts);
        if (program_.has_lights) numbers(Stack::t_max, t_max);
        if (program_.attenuates) numbers(Stack::way, way);
        if (program_.uses_keys) words(Stack::key, key);
        if (program_.two_words) words(Stack::inside1, list.high);
        if (!program_.groups.empty()) words(Stack::sphere_contacts, sphere_contacts);
        stack_.resize(at + packing.count);
    };
    const U plain_code = batch.code & U(~(RayCode::level_mask | RayCode::straight));
    const F3& throughput = batch.throughput;

    const M passes = nothing | (glass & batch.is_shadow);
    if (any(passes)) {
        push(passes, rays.world.direction, throughput, batch.weight, rays.t_max - t,
             select(nothing, batch.way_before + t, F(0.0)), batch.after, after.rank,
             plain_code | level_word | only(but_not(passes, batch.is_shadow), U(RayCode::straight)),
             batch.key);
    }

    const M splits = but_not(glass, batch.is_shadow);
    if (any(splits)) {
        const F eta = before.ior / after.ior;
        const F facing = dot(normal, rays.world.direction);
        const F3 n = select(F(0.0) < facing, F(-1.0) * normal, normal);
        const F cosine = min(F(1.0), abs(facing));
        const F k = F(1.0) - eta * eta * (F(1.0) - cosine * cosine);
        const M total = k <= F(0.0);
        const F refracted = sqrt(max(k, F(0.0)));
        // Both polarisations over one denominator.
        const F s_up = eta * cosine - refracted, s_down = eta * cosine + refracted;
        const F p_up = eta * refracted - cosine, p_down = eta * refracted + cosine;
        const F inverse = F(1.0) / (s_down * p_down);
        const F s = s_up * p_down * inverse, p = p_up * s_down * inverse;
        const F reflectance = select(total, F(1.0), F(0.5) * (s * s + p * p));
        const F transmittance = F(1.0) - reflectance;

        F reflect_factor = reflectance, transmit_factor = transmittance;
        F reflect_weight = batch.weight * reflectance,
          transmit_weight = batch.weight * transmittance;
        const F least(program_.whitted ? program_.least_weight : 0.0);
        M reflects = splits & (F(0.0) < reflectance);
        M transmits = but_not(splits & (least < transmittance), total);
        U reflect_key = batch.key, transmit_key = batch.key;
        if (program_.sampled) {
            choose(splits, reflectance, transmittance, batch.weight, batch.key, reflects, transmits,
                   reflect_factor, transmit_factor, reflect_weight, transmit_weight, reflect_key,
                   transmit_key);
        }
        counts_.reflected += count(reflects);
        counts_.refracted += count(transmits);
        const M may_go_on = level < F(double(program_.most_levels));
        const F floor(program_.least_weight);
        const F3 mirrored = unit(rays.world.direction + F(2.0) * cosine * n);
        const M bends = F(1e-10) <= abs(eta - F(1.0));
        const F3 bent =
            select(bends, unit(eta * rays.world.direction + s_up * n), rays.world.direction);
        push(reflects & may_go_on & (floor <= reflect_weight), mirrored,
             reflect_factor * throughput, reflect_weight, F(infinity), F(0.0), batch.before,
             before.rank, plain_code | level_word | U(RayCode::reflected), reflect_key);
        push(transmits & may_go_on & (floor <= transmit_weight), bent, transmit_factor * throughput,
             transmit_weight, F(infinity), F(0.0), batch.after, after.rank,
             plain_code | level_word | only(but_not(transmits, bends), U(RayCode::straight)),
             transmit_key);
    }
    if (any(dressed))
        dress(batch, dressed, by_surface, point, normal, owner, face, magnitude, level, before,
              after);
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
