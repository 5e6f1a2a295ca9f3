// One step of the kernel: the rays on top of the stack go to where their medium next changes, and
// what they split into is pushed. docs/kernels.md walks through it.

#if defined(MENISCUS_LANES_STEP) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_STEP
#undef MENISCUS_LANES_STEP
#else
#define MENISCUS_LANES_STEP
#endif

#include "lanes/chance.hpp"
#include "lanes/lists-inl.hpp"
#include "lanes/meet-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

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
    rays.sure_start = F(-2.0 * program_.tolerance_units * unit_roundoff) * rays.birth;
    rays.thin = F(thin_chord) * rays.largest;
    rays.contacts = words(Stack::contacts);
    batch.throughput = {numbers(Stack::red), numbers(Stack::green), numbers(Stack::blue)};
    batch.weight = numbers(Stack::weight);
    batch.way_before = program_.attenuates ? numbers(Stack::way) : F(0.0);
    batch.code = words(Stack::code);
    batch.key = program_.uses_keys ? words(Stack::key) : U(0);
    for (int w = 0; w < program_.words; ++w)
        batch.inside.word[w] = words(Stack::Field(Stack::inside + w));
    batch.sphere_contacts = program_.groups.empty() ? U(0) : words(Stack::sphere_contacts);
    batch.is_shadow =
        program_.has_lights ? !((batch.code & U(RayCode::shadow)) == U(0)) : no_lanes();
    batch.is_mirrored = but_not(!((batch.code & U(RayCode::reflected)) == U(0)), batch.is_shadow);
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
        sphere_contacts(batch.sphere_contacts_after);
    Words before_words[list_words], after_words[list_words];
    for (int w = 0; w < program_.words; ++w) {
        before_words[w] = Words(batch.before.word[w]);
        after_words[w] = Words(batch.after.word[w]);
    }
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
        for (int w = 0; w < program_.words; ++w) {
            surface.before[std::size_t(w)] = before_words[w][lane];
            surface.after[std::size_t(w)] = after_words[w][lane];
        }
        surface.contacts = contacts[lane];
        if (!program_.groups.empty()) surface.sphere_contacts = sphere_contacts[lane];
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
    ray.code = stack_.word(Stack::code)[at];
    ray.key = stack_.word(Stack::key)[at];
    for (int w = 0; w < program_.words; ++w)
        ray.inside[std::size_t(w)] = stack_.word(Stack::Field(Stack::inside + w))[at];
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
    find_event(batch, before, after);
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
    const M clear =
        program_.has_dressed
            ? but_not(member_met, select_mask(after_owns, after.dressed, before.dressed))
            : member_met;
    // Nothing is there: the same solid before and after, or like media under a clear skin.
    const M alike = program_.ior_tells_medium ? before.ior == after.ior
                                              : before.medium == after.medium;
    const M nothing = same | (clear & alike);
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
    const auto push = [&](M which, const F3& direction, const F3& light, F weight, F t_max, F way,
                          const List& list, U code, U key) HWY_ATTR {
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
        words(Stack::code, code);
        for (int w = 0; w < program_.words; ++w)
            words(Stack::Field(Stack::inside + w), list.word[w]);
        words(Stack::contacts, batch.contacts);
        if (program_.has_lights) numbers(Stack::t_max, t_max);
        if (program_.attenuates) numbers(Stack::way, way);
        if (program_.uses_keys) words(Stack::key, key);
        if (!program_.groups.empty()) words(Stack::sphere_contacts, batch.sphere_contacts_after);
        stack_.resize(at + packing.count);
    };
    const U plain_code = batch.code & U(~(RayCode::level_mask | RayCode::straight));
    const F3& throughput = batch.throughput;

    const M passes = nothing | (glass & batch.is_shadow);
    if (any(passes)) {
        push(passes, rays.world.direction, throughput, batch.weight, rays.t_max - t,
             select(nothing, batch.way_before + t, F(0.0)), batch.after,
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
             plain_code | level_word | U(RayCode::reflected), reflect_key);
        push(transmits & may_go_on & (floor <= transmit_weight), bent, transmit_factor * throughput,
             transmit_weight, F(infinity), F(0.0), batch.after,
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
