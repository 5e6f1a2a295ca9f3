// One step of the kernel: the rays on top of the stack go to where their medium next changes, and
// what they split into is pushed. docs/kernels.md walks through it.

#if defined(MENISCUS_LANES_STEP) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_STEP
#undef MENISCUS_LANES_STEP
#else
#define MENISCUS_LANES_STEP
#endif

#include <cmath>

#include "lanes/chance.hpp"
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

/// A stretch of one lane's ray inside a small sphere.
struct SphereStretch {
    double in, out;
    int rank;
};
struct SphereStretches {
    static constexpr int most = 12;
    SphereStretch at[most];
    int size = 0;
};

class Kernel {
public:
    Kernel(const Program& program, Host& host, RayStack& stack, std::int64_t* sums)
        : program_(program), host_(host), stack_(stack), sums_(sums) {
        iors_.push_back(program.outside.ior);
        media_.push_back(double(program.outside.medium));
        attenuation_.push_back(program.outside.attenuates);
        clear_.push_back(1.0);
        for (std::size_t rank = 0; rank < program.members.size(); ++rank) {
            const Member& member = program.members[rank];
            if (member.in_group) group_bits_[rank / 64] |= 1ull << (rank % 64);
            iors_.push_back(member.ior);
            media_.push_back(double(member.medium));
            attenuation_.push_back(member.attenuates);
            clear_.push_back(member.clear);
            any_attenuates_ = any_attenuates_ || member.attenuates;
        }
        any_attenuates_ = any_attenuates_ || program.outside.attenuates;
    }

    Counts run() {
        while (true) {
            if (stack_.size() < lanes) host_.more_rays(stack_, lanes - stack_.size());
            if (stack_.size() == 0) return counts_;
            step();
        }
    }

private:
    HWY_INLINE void step();
    HWY_INLINE void find_small_spheres(const Rays& rays, const Words (&inside)[list_words],
                                       const Words& sphere_contacts, const Doubles& top, F& nearest,
                                       F& pivot_magnitude, M& unsure);
    HWY_INLINE void choose(M splits, F reflectance, F transmittance, F weight, U key, M& reflects,
                           M& transmits, F& reflect_factor, F& transmit_factor, F& reflect_weight,
                           F& transmit_weight, U& reflect_key, U& transmit_key) const;
    WaitingRay waiting(std::size_t at);
    HWY_INLINE bool sphere_stretch(const geom::Vec3& o, const geom::Vec3& d, const geom::Vec3& c,
                                   double r, bool inside, bool has_contact, double largest,
                                   double birth, SphereStretch& result, bool& unsure) const;
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
    std::vector<double> iors_, media_, attenuation_, clear_;  // by rank + 1
    bool any_attenuates_ = false;
    std::uint64_t group_bits_[list_words] = {};  // the ranks of grouped spheres
    SphereStretches small_[lanes];
};

/// The stretch of a ray in one small sphere, as `sphere_span` and `resolve` have it for lanes;
/// false if there is none.
HWY_INLINE bool Kernel::sphere_stretch(const geom::Vec3& o, const geom::Vec3& d,
                                       const geom::Vec3& c, double r, bool inside, bool has_contact,
                                       double largest, double birth, SphereStretch& result,
                                       bool& unsure) const {
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
    const double units = program_.tolerance_units * unit_roundoff;
    const double sure_start = 2.0 * std::max(units * (birth + size), program_.contact_tolerance);
    if (inside) {
        if (t1 < -sure_start && !has_contact) unsure = true;
        result.in = -infinity;
        result.out = std::max(t1, 0.0);
        return true;
    }
    if (!hit || !(t1 > 0.0)) return false;
    const double start = std::max(t0, 0.0), chord = t1 - start;
    const double magnitude = largest + size + start;
    if (chord <= std::max(units * magnitude, program_.contact_tolerance)) return false;
    if (chord < std::max(1e-6 * magnitude, 2.0 * program_.contact_tolerance)) unsure = true;
    if (t0 < -sure_start && !has_contact) unsure = true;
    result.in = start;
    result.out = t1;
    return true;
}

/// Small spheres are met by few rays each: lane by lane, eight spheres at once. Draws `nearest`
/// nearer where one of them is a true crossing.
HWY_INLINE void Kernel::find_small_spheres(const Rays& rays, const Words (&inside)[list_words],
                                           const Words& sphere_contacts, const Doubles& top,
                                           F& nearest, F& pivot_magnitude, M& unsure) {
    const Doubles ox(rays.origin.x), oy(rays.origin.y), oz(rays.origin.z);
    const Doubles dx(rays.direction.x), dy(rays.direction.y), dz(rays.direction.z);
    const Doubles largest(rays.largest), birth(rays.birth);
    Doubles near(nearest), pivot(pivot_magnitude);
    std::uint32_t doubtful = 0;
    const std::uint32_t active = bits(rays.active);

    const auto offer = [&](std::size_t lane, int rank, bool is_inside, bool has_contact) {
        const Member& member = program_.members[std::size_t(rank)];
        SphereStretch stretch{};
        bool doubt = false;
        const bool met = sphere_stretch(
            {ox[lane], oy[lane], oz[lane]}, {dx[lane], dy[lane], dz[lane]}, member.center,
            member.radius, is_inside, has_contact, largest[lane], birth[lane], stretch, doubt);
        if (doubt) doubtful |= 1u << lane;
        if (!met) return;
        stretch.rank = rank;
        SphereStretches& list = small_[lane];
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
            pivot[lane] = std::max({std::abs(member.center.x), std::abs(member.center.y),
                                    std::abs(member.center.z)}) +
                          member.radius;
        }
    };
    // Those that the list or a contact names, first: no box can hide them.
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        small_[lane].size = 0;
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
        const F3 e = rays.origin - F3(group.center);
        const F b = dot(e, rays.direction);
        const F3 f = e - b * rays.direction;
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
    nearest = load(near.at);
    pivot_magnitude = load(pivot.at);
    unsure = unsure | mask_of(doubtful);
}

/// The face number of a contact, in its place in the word of all contacts.
HWY_INLINE U contact_word(F face, int index) {
    const F with_exponent = face + F(1.0 + 0x1p52);
    return shift_left(
        U(hn::BitCast(integers, with_exponent.a), hn::BitCast(integers, with_exponent.b)) & U(15),
        4 * index);
}

/// A vector that is unit length to rounding but for the few roundings since it was made.
HWY_INLINE F3 unit(F3 v) { return (F(1.5) - F(0.5) * dot(v, v)) * v; }

/// A point put on a face, and the shape's outward unit normal there.
struct FacePoint {
    F3 point, normal;
};

HWY_INLINE FacePoint face_point(const Solid& solid, F3 world, F face) {
    F3 p = world;
    if (solid.placed)
        p = transform(solid.transform.inverse_linear(), world - F3(solid.transform.shift()));
    F3 n, way;  // the way from the point to the face
    switch (solid.kind) {
        case Kind::sphere: {
            const F3 e = p - F3(solid.center);
            const F length = sqrt(dot(e, e));
            n = (F(1.0) / length) * e;
            way = (F(solid.radius) - length) * n;
            break;
        }
        case Kind::half_space:
            n = F3(solid.center);
            way = (F(solid.distance) - dot(p, n)) * n;
            break;
        case Kind::box: {
            const F coordinate[3] = {p.x, p.y, p.z};
            F component[3], back[3];
            for (int axis = 0; axis < 3; ++axis) {
                const M low = face == F(2.0 * axis), high = face == F(2.0 * axis + 1.0);
                component[axis] = select(high, F(1.0), only(low, F(-1.0)));
                back[axis] =
                    only(low | high,
                         select(high, F(solid.high[axis]), F(solid.low[axis])) - coordinate[axis]);
            }
            n = {component[0], component[1], component[2]};
            way = {back[0], back[1], back[2]};
            break;
        }
        case Kind::cylinder: {
            const F3 axis(solid.axis);
            const F3 e = p - F3(solid.center);
            const F along = dot(e, axis);
            const F3 across = e - along * axis;
            const F distance = sqrt(dot(across, across));
            const M base = face == F(1.0), cap = face == F(2.0);
            const F3 side = (F(1.0) / distance) * across;
            const F sign = select(cap, F(1.0), F(-1.0));
            n = select(base | cap, sign * axis, side);
            way = select(base | cap, (only(cap, F(solid.length)) - along) * axis,
                         (F(solid.radius) - distance) * side);
            break;
        }
        case Kind::lathe: {
            const F radius = sqrt(p.x * p.x + p.z * p.z);
            const F inverse = F(1.0) / radius;
            F a(0.0), b(1.0), c(0.0);
            for (std::size_t i = 0; i < solid.pieces.size(); ++i) {
                const M here = face == F(double(i));
                a = select(here, F(solid.pieces[i].a), a);
                b = select(here, F(solid.pieces[i].b), b);
                c = select(here, F(solid.pieces[i].c), c);
            }
            const F out = select(a == F(0.0), F(0.0), a * inverse);
            n = {out * p.x, b, out * p.z};
            way = (c - a * radius - b * p.y) * n;
            break;
        }
    }
    if (!solid.placed) return {world + way, n};
    // Normals go by the inverse transpose.
    const geom::Mat3& inverse = solid.transform.inverse_linear();
    const F3 turned{dot(n, F3(inverse[0])), dot(n, F3(inverse[1])), dot(n, F3(inverse[2]))};
    return {world + transform(solid.transform.linear(), way),
            (F(1.0) / sqrt(dot(turned, turned))) * turned};
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

/// What the rays of a step meet next, and where that leads to.
struct Meeting {
    M met;  // an event lies ahead
    F t;
    F rank_before, rank_after;  // `no_rank` for the outside
    U before[list_words], after[list_words];
    U contacts;
    Words sphere_contacts;
    F owner;        // rank of the solid whose surface it is; no_rank: none, or `surface`
    F surface;      // index of the solid that is always met, or no_rank
    F solid, face;  // index of the owner or surface among the solids, and its face
};

HWY_INLINE void Kernel::step() {
    const std::size_t n = std::min(stack_.size(), lanes);
    const std::size_t base = stack_.size() - n;
    stack_.resize(base);
    counts_.segments += n;

    using Stack = RayStack;
    Rays rays;
    rays.active = first_lanes(n);
    rays.origin = {load(stack_[Stack::ox] + base), load(stack_[Stack::oy] + base),
                   load(stack_[Stack::oz] + base)};
    rays.direction = {load(stack_[Stack::dx] + base), load(stack_[Stack::dy] + base),
                      load(stack_[Stack::dz] + base)};
    rays.t_max = load(stack_[Stack::t_max] + base);
    rays.largest = max(max(abs(rays.origin.x), abs(rays.origin.y)), abs(rays.origin.z));
    const F birth = load(stack_[Stack::birth] + base);
    rays.birth = max(birth, rays.largest);
    rays.contacts = load(stack_.word(Stack::contacts) + base);
    F3 throughput{load(stack_[Stack::red] + base), load(stack_[Stack::green] + base),
                  load(stack_[Stack::blue] + base)};
    const F weight = load(stack_[Stack::weight] + base);
    const F way_before = load(stack_[Stack::way] + base);
    const F top = select(rays.active, load(stack_[Stack::top] + base), F(double(no_rank)));
    const U code = load(stack_.word(Stack::code) + base);
    const U key = load(stack_.word(Stack::key) + base);
    const M is_shadow = !((code & U(RayCode::shadow)) == U(0));
    const M is_mirrored = but_not(!((code & U(RayCode::reflected)) == U(0)), is_shadow);
    const U sphere_contacts = load(stack_.word(Stack::sphere_contacts) + base);
    U inside[list_words];
    for (int w = 0; w < list_words; ++w)
        inside[w] = load(stack_.word(Stack::Field(Stack::inside0 + w)) + base);

    // Where each solid's stretches of the rays lie, and the nearest crossing that is true.
    F nearest(infinity), pivot_magnitude(0.0);
    M unsure = no_lanes();
    Stretch stretches[2 * most_solids];
    std::size_t slots = 0;
    for (std::size_t i = 0; i < program_.solids.size(); ++i) {
        const Solid& solid = program_.solids[i];
        const int place = solid.rank >= 0 ? solid.rank : most_members + int(i);
        const M listed = !((inside[place / 64] & U(1ull << (place % 64))) == U(0));
        const U contact = contact_of(rays, int(i));
        const M has_contact = !(contact == U(0));
        const M in_shape = solid.inverse ? !listed : listed;
        const M is_top = top == F(double(solid.rank)), is_below = top < F(double(solid.rank));
        M unseen = no_lanes();
        if (!solid.to_camera) unseen = !(is_shadow | is_mirrored);
        if (!solid.to_mirrors) unseen = unseen | is_mirrored;
        if (!solid.to_lights) unseen = unseen | is_shadow;
        const bool hides = !(solid.to_camera && solid.to_mirrors && solid.to_lights);
        const M doubts_before = unsure;
        const auto take = [&](Stretch stretch) {
            if (hides) {
                stretch.in = select(unseen, F(infinity), stretch.in);
                stretch.out = select(unseen, F(infinity), stretch.out);
                unsure = but_not(unsure, but_not(unseen, doubts_before));
            }
            const M enters = F(-infinity) < stretch.in;
            const F crossing = select(enters, stretch.in, stretch.out);
            F candidate = crossing;
            if (solid.rank >= 0)
                candidate = select(select_mask(enters, solid.inverse ? is_top : is_below,
                                               solid.inverse ? is_below : is_top),
                                   crossing, F(infinity));
            const M nearer = candidate < nearest;
            nearest = select(nearer, candidate, nearest);
            pivot_magnitude = select(nearer, F(solid.magnitude), pivot_magnitude);
            stretches[slots++] = stretch;
        };
        if (solid.kind == Kind::lathe) {
            const M known = solid.rank >= 0 ? !no_lanes() : has_contact;
            Stretch first, second;
            lathe_stretches(program_, solid, rays, known, in_shape, first, second, unsure);
            take(first);
            take(second);
            continue;
        }
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
            default:
                span = half_space_span(solid, rays, contact);
                break;
        }
        // What stands in no list is judged by place, but where the ray was born on it.
        const M begins_inside =
            solid.rank >= 0 ? in_shape
                            : select_mask(has_contact, in_shape,
                                          span.hit & (span.t0 < F(0.0)) & (F(0.0) < span.t1));
        take(resolve(program_, solid, rays, span, begins_inside, has_contact, unsure));
    }
    if (!program_.groups.empty()) {
        const Words inside_words[list_words] = {Words(inside[0]), Words(inside[1])};
        find_small_spheres(rays, inside_words, Words(sphere_contacts), Doubles(top), nearest,
                           pivot_magnitude, unsure);
    }

    // What coincides with it, and the lists just before and just after.
    Meeting meeting;
    meeting.met = rays.active & (nearest < F(infinity)) & (nearest <= rays.t_max);
    const F t = select(meeting.met, nearest, min(rays.t_max, F(1e300)));
    meeting.t = t;
    meeting.rank_before = meeting.rank_after = F(double(no_rank));
    meeting.surface = meeting.solid = F(double(no_rank));
    meeting.face = F(0.0);
    for (int w = 0; w < list_words; ++w) meeting.before[w] = meeting.after[w] = U(0);
    meeting.contacts = U(0);
    const F units(program_.tolerance_units * unit_roundoff);
    const F reach =
        max(F(1e-7) * (rays.largest + t + pivot_magnitude), F(100.0 * program_.contact_tolerance));
    F solid_before{double(no_rank)}, solid_after = solid_before;
    F face_before(0.0), face_after(0.0), surface_face(0.0);
    F false_crossings(0.0);
    M torn = no_lanes();
    slots = 0;
    for (std::size_t i = 0; i < program_.solids.size(); ++i) {
        const Solid& solid = program_.solids[i];
        const F tolerance =
            max(units * (rays.largest + t + max(pivot_magnitude, F(solid.magnitude))),
                F(program_.contact_tolerance));
        M before = no_lanes(), after = no_lanes(), once = no_lanes();
        F face(0.0);
        for (int part = 0; part < (solid.kind == Kind::lathe ? 2 : 1); ++part) {
            const Stretch& stretch = stretches[slots++];
            const F in_distance = abs(stretch.in - t), out_distance = abs(stretch.out - t);
            const M enters = in_distance <= tolerance, leaves = out_distance <= tolerance;
            torn = torn | (enters ^ (in_distance <= reach)) | (leaves ^ (out_distance <= reach));
            const M entered = but_not(stretch.in < t, enters);
            const M left = but_not(stretch.out < t, leaves);
            before = before | but_not(entered, left);
            after = after | but_not(entered | enters, left | leaves);
            once = once ^ (enters ^ leaves);
            face = select(enters, stretch.face_in, select(leaves, stretch.face_out, face));
            false_crossings = false_crossings +
                              only(entered & (F(-infinity) < stretch.in), F(1.0)) +
                              only(left, F(1.0));
        }
        meeting.contacts = meeting.contacts | only(once, contact_word(face, int(i)));
        const int place = solid.rank >= 0 ? solid.rank : most_members + int(i);
        if (solid.inverse) {
            before = !before;
            after = !after;
        }
        const U bit(1ull << (place % 64));
        meeting.before[place / 64] = meeting.before[place / 64] | only(before, bit);
        meeting.after[place / 64] = meeting.after[place / 64] | only(after, bit);
        if (solid.rank < 0) {
            meeting.surface = select(once, F(double(i)), meeting.surface);
            surface_face = select(once, face, surface_face);
            continue;
        }
        // Solids stand in the order of their ranks.
        meeting.rank_before = select(before, F(double(solid.rank)), meeting.rank_before);
        meeting.rank_after = select(after, F(double(solid.rank)), meeting.rank_after);
        solid_before = select(before, F(double(i)), solid_before);
        solid_after = select(after, F(double(i)), solid_after);
        face_before = select(before, face, face_before);
        face_after = select(after, face, face_after);
    }
    meeting.sphere_contacts = Words(U(0));
    if (!program_.groups.empty()) {
        std::uint32_t doubtful = 0;
        Doubles rank_before(meeting.rank_before), rank_after(meeting.rank_after);
        const Doubles at(t), margin(reach), largest(rays.largest), pivot(pivot_magnitude);
        const std::uint32_t active = bits(rays.active);
        std::uint64_t skipped_crossings = 0;
        bool some = false;
        Words before[list_words] = {Words(meeting.before[0]), Words(meeting.before[1])};
        Words after[list_words] = {Words(meeting.after[0]), Words(meeting.after[1])};
        for (std::uint32_t left = active; left; left &= left - 1) {
            const std::size_t lane = std::size_t(__builtin_ctz(left));
            const SphereStretches& list = small_[lane];
            int contacts = 0;
            for (int k = 0; k < list.size; ++k) {
                const SphereStretch& stretch = list.at[k];
                const Member& member = program_.members[std::size_t(stretch.rank)];
                const double size = std::max({std::abs(member.center.x), std::abs(member.center.y),
                                              std::abs(member.center.z)}) +
                                    member.radius;
                const double tolerance =
                    std::max(program_.tolerance_units * unit_roundoff *
                                 (largest[lane] + at[lane] + std::max(pivot[lane], size)),
                             program_.contact_tolerance);
                const double in_distance = std::abs(stretch.in - at[lane]);
                const double out_distance = std::abs(stretch.out - at[lane]);
                const bool enters = in_distance <= tolerance, leaves = out_distance <= tolerance;
                if (enters != (in_distance <= margin[lane]) ||
                    leaves != (out_distance <= margin[lane]))
                    doubtful |= 1u << lane;
                const bool entered = stretch.in < at[lane] && !enters;
                const bool gone = stretch.out < at[lane] && !leaves;
                const std::uint64_t bit = 1ull << (stretch.rank % 64);
                if (entered && !gone) {
                    before[stretch.rank / 64][lane] |= bit;
                    rank_before[lane] = std::max(rank_before[lane], double(stretch.rank));
                    some = true;
                }
                if ((entered || enters) && !(gone || leaves)) {
                    after[stretch.rank / 64][lane] |= bit;
                    rank_after[lane] = std::max(rank_after[lane], double(stretch.rank));
                    some = true;
                }
                if (enters != leaves) {
                    if (contacts == 2) {
                        doubtful |= 1u << lane;
                    } else {
                        meeting.sphere_contacts[lane] |= std::uint64_t(stretch.rank + 1)
                                                         << (32 * contacts++);
                    }
                }
                skipped_crossings += std::uint64_t(entered && stretch.in > -infinity) + gone;
            }
        }
        counts_.false_crossings += skipped_crossings;
        torn = torn | mask_of(doubtful);
        if (some) {
            meeting.rank_before = load(rank_before.at);
            meeting.rank_after = load(rank_after.at);
            for (int w = 0; w < list_words; ++w) {
                meeting.before[w] = load(before[w].at);
                meeting.after[w] = load(after[w].at);
            }
        }
    }
    unsure = rays.active & (unsure | (meeting.met & torn));

    // Too close to call: the host follows these.
    if (any(unsure)) {
        for (std::uint32_t left = bits(unsure); left; left &= left - 1) {
            const std::size_t lane = std::size_t(__builtin_ctz(left));
            const WaitingRay ray = waiting(base + lane);
            add_light(ray.code, host_.follow(ray));
            --counts_.segments;
            ++counts_.handed_over;
        }
        rays.active = but_not(rays.active, unsure);
        meeting.met = but_not(meeting.met, unsure);
    }
    {
        Doubles skipped(only(rays.active, false_crossings));
        double sum = 0.0;
        for (const double x : skipped.at) sum += x;
        counts_.false_crossings += std::uint64_t(sum);
    }
    counts_.true_crossings += count(meeting.met);

    const M is_straight = !((code & U(RayCode::straight)) == U(0));
    const U level_word = (code & U(RayCode::level_mask)) +
                         select(is_straight | is_shadow, U(0), U(RayCode::one_level));
    const F level = to_double(shift_right(level_word, RayCode::level_shift));
    {
        Doubles deepest(only(rays.active, level));
        for (const double x : deepest.at)
            counts_.deepest_level = std::max(counts_.deepest_level, int(x));
    }

    const M by_surface = meeting.met & (F(0.0) <= meeting.surface);
    const F owner = max(meeting.rank_before, meeting.rank_after);
    const F media_before = gather(media_.data(), meeting.rank_before + F(1.0));
    const F media_after = gather(media_.data(), meeting.rank_after + F(1.0));
    const M is_clear =
        but_not(meeting.met & (F(0.0) < gather(clear_.data(), owner + F(1.0))), by_surface);
    // Nothing is there: the same solid before and after, or like media under a clear skin.
    const M nothing =
        but_not(meeting.met & (meeting.rank_before == meeting.rank_after), by_surface) |
        (is_clear & (media_before == media_after));
    const M glass = but_not(is_clear, nothing);
    const M dressed = but_not(but_not(meeting.met, nothing), glass);

    // The medium on the way, up to the event or to the light.
    const M gone = but_not(rays.active, meeting.met);
    if (any_attenuates_) {
        const M dims = (F(0.0) < gather(attenuation_.data(), meeting.rank_before + F(1.0))) &
                       (glass | dressed | (gone & is_shadow));
        if (any(dims)) {
            Doubles red(throughput.x), green(throughput.y), blue(throughput.z);
            const Doubles way(way_before + t), rank(meeting.rank_before);
            const std::uint32_t shadows = bits(is_shadow);
            for (std::uint32_t left = bits(dims); left; left &= left - 1) {
                const std::size_t lane = std::size_t(__builtin_ctz(left));
                const geom::Vec3 share =
                    host_.transmittance(int(rank[lane]), way[lane], (shadows >> lane & 1u) != 0);
                red[lane] *= share.x;
                green[lane] *= share.y;
                blue[lane] *= share.z;
            }
            throughput = {load(red.at), load(green.at), load(blue.at)};
        }
    }

    // Light that arrives: of the sky, and of lights that nothing hides.
    if (any(gone)) {
        const M plain =
            gone & (is_shadow | (program_.constant_sky ? meeting.rank_before == F(double(no_rank))
                                                       : no_lanes()));
        const F3 sky(program_.sky);
        const F3 light =
            select(is_shadow, throughput,
                   F3{throughput.x * sky.x, throughput.y * sky.y, throughput.z * sky.z});
        const Doubles red(light.x), green(light.y), blue(light.z);
        const Words codes(code);
        for (std::uint32_t left = bits(plain); left; left &= left - 1) {
            const std::size_t lane = std::size_t(__builtin_ctz(left));
            add_light(codes[lane], {red[lane], green[lane], blue[lane]});
        }
        if (const M other = but_not(gone, plain); any(other)) {
            const Doubles dx(rays.direction.x), dy(rays.direction.y), dz(rays.direction.z),
                rank(meeting.rank_before), r(throughput.x), g(throughput.y), b(throughput.z);
            for (std::uint32_t left = bits(other); left; left &= left - 1) {
                const std::size_t lane = std::size_t(__builtin_ctz(left));
                const geom::Vec3 seen = host_.sky({dx[lane], dy[lane], dz[lane]}, int(rank[lane]));
                add_light(codes[lane], {r[lane] * seen.x, g[lane] * seen.y, b[lane] * seen.z});
            }
        }
    }
    if (!any(meeting.met)) return;

    // The point, put back on its face, and the normal there.
    meeting.owner = select(by_surface, F(double(no_rank)), owner);
    meeting.solid =
        select(by_surface, meeting.surface,
               select(meeting.rank_before < meeting.rank_after, solid_after, solid_before));
    meeting.face =
        select(by_surface, surface_face,
               select(meeting.rank_before < meeting.rank_after, face_after, face_before));
    F3 point = rays.origin + t * rays.direction;
    F3 normal(geom::Vec3{0.0, 1.0, 0.0});
    F owner_magnitude(0.0);
    const M on_face =
        but_not(meeting.met, but_not(meeting.rank_before == meeting.rank_after, by_surface));
    for (std::size_t i = 0; i < program_.solids.size(); ++i) {
        const Solid& solid = program_.solids[i];
        const M here = on_face & (meeting.solid == F(double(i))) &
                       (by_surface | (meeting.owner == F(double(solid.rank))));
        if (!any(here)) continue;
        FacePoint put = face_point(solid, point, meeting.face);
        if (solid.inverse) put.normal = F(-1.0) * put.normal;
        point = select(here, put.point, point);
        normal = select(here, put.normal, normal);
        owner_magnitude = select(here, F(solid.magnitude), owner_magnitude);
    }
    if (!program_.groups.empty()) {
        const Doubles ranks(select(on_face, meeting.owner, F(double(no_rank))));
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
            owner_magnitude = select(
                mask, max(max(abs(center.x), abs(center.y)), abs(center.z)) + r, owner_magnitude);
        }
    }
    const F magnitude = rays.largest + t + owner_magnitude;

    // Rays that go on.
    stack_.reserve(stack_.size() + 3 * lanes);
    const auto push = [&](M which, const F3& direction, const F3& light, F child_weight,
                          F child_t_max, F child_way, const U(&list)[list_words], F child_top,
                          U child_code, U child_key) {
        const std::uint32_t who = bits(which);
        if (who == 0) return;
        const Packing packing(who);
        const std::size_t at = stack_.size();
        store(point.x, packing, stack_[Stack::ox] + at);
        store(point.y, packing, stack_[Stack::oy] + at);
        store(point.z, packing, stack_[Stack::oz] + at);
        store(direction.x, packing, stack_[Stack::dx] + at);
        store(direction.y, packing, stack_[Stack::dy] + at);
        store(direction.z, packing, stack_[Stack::dz] + at);
        store(light.x, packing, stack_[Stack::red] + at);
        store(light.y, packing, stack_[Stack::green] + at);
        store(light.z, packing, stack_[Stack::blue] + at);
        store(child_weight, packing, stack_[Stack::weight] + at);
        store(child_t_max, packing, stack_[Stack::t_max] + at);
        store(magnitude, packing, stack_[Stack::birth] + at);
        store(child_way, packing, stack_[Stack::way] + at);
        store(child_top, packing, stack_[Stack::top] + at);
        store(child_code, packing, stack_.word(Stack::code) + at);
        store(child_key, packing, stack_.word(Stack::key) + at);
        for (int w = 0; w < list_words; ++w)
            store(list[w], packing, stack_.word(Stack::Field(Stack::inside0 + w)) + at);
        store(meeting.contacts, packing, stack_.word(Stack::contacts) + at);
        store(load(meeting.sphere_contacts.at), packing, stack_.word(Stack::sphere_contacts) + at);
        stack_.resize(at + packing.count);
    };
    const U plain_code = code & U(~(RayCode::level_mask | RayCode::straight));

    const M passes = nothing | (glass & is_shadow);
    push(passes, rays.direction, throughput, weight, rays.t_max - t,
         select(nothing, way_before + t, F(0.0)), meeting.after, meeting.rank_after,
         plain_code | level_word | only(but_not(passes, is_shadow), U(RayCode::straight)), key);

    const M splits = but_not(glass, is_shadow);
    if (any(splits)) {
        const F ior_before = gather(iors_.data(), meeting.rank_before + F(1.0));
        const F ior_after = gather(iors_.data(), meeting.rank_after + F(1.0));
        const F eta = ior_before / ior_after;
        const F facing = dot(normal, rays.direction);
        const M turn = F(0.0) < facing;
        const F3 n = select(turn, F(-1.0) * normal, normal);
        const F cosine = min(F(1.0), abs(facing));
        const F k = F(1.0) - eta * eta * (F(1.0) - cosine * cosine);
        const M total = k <= F(0.0);
        const F refracted = sqrt(max(k, F(0.0)));
        const F s = (eta * cosine - refracted) / (eta * cosine + refracted);
        const F p = (eta * refracted - cosine) / (eta * refracted + cosine);
        const F reflectance = select(total, F(1.0), F(0.5) * (s * s + p * p));
        const F transmittance = F(1.0) - reflectance;

        Doubles reflect_by(reflectance), transmit_by(transmittance);
        F reflect_factor = reflectance, transmit_factor = transmittance;
        F reflect_weight = weight * reflectance, transmit_weight = weight * transmittance;
        const F least(program_.whitted ? program_.least_weight : 0.0);
        M reflects = splits & (F(0.0) < reflectance);
        M transmits = but_not(splits & (least < transmittance), total);
        U reflect_key = key, transmit_key = key;
        if (program_.sampled) {
            choose(splits, reflectance, transmittance, weight, key, reflects, transmits,
                   reflect_factor, transmit_factor, reflect_weight, transmit_weight, reflect_key,
                   transmit_key);
        }
        counts_.reflected += count(reflects);
        counts_.refracted += count(transmits);
        const M may_go_on = level < F(double(program_.most_levels));
        const F floor(program_.least_weight);
        const F3 mirrored = unit(rays.direction + F(2.0) * cosine * n);
        const M bends = F(1e-10) <= abs(eta - F(1.0));
        const F3 bent = select(bends, unit(eta * rays.direction + (eta * cosine - refracted) * n),
                               rays.direction);
        push(reflects & may_go_on & (floor <= reflect_weight), mirrored,
             reflect_factor * throughput, reflect_weight, F(infinity), F(0.0), meeting.before,
             meeting.rank_before, plain_code | level_word, reflect_key);
        push(transmits & may_go_on & (floor <= transmit_weight), bent, transmit_factor * throughput,
             transmit_weight, F(infinity), F(0.0), meeting.after, meeting.rank_after,
             plain_code | level_word | only(but_not(transmits, bends), U(RayCode::straight)),
             transmit_key);
    }

    // Surfaces that the host shades.
    if (!any(dressed)) return;
    const Doubles px(point.x), py(point.y), pz(point.z), nx(normal.x), ny(normal.y), nz(normal.z),
        red(throughput.x), green(throughput.y), blue(throughput.z), solids(meeting.solid),
        owners(meeting.owner), faces(meeting.face), before(meeting.rank_before),
        after(meeting.rank_after), magnitudes(magnitude), levels(level), ways(t), ox(rays.origin.x),
        oy(rays.origin.y), oz(rays.origin.z), dx(rays.direction.x), dy(rays.direction.y),
        dz(rays.direction.z), weights(weight), limits(rays.t_max);
    const Words codes(code), keys(key), contacts(meeting.contacts),
        before_words[list_words] = {Words(meeting.before[0]), Words(meeting.before[1])},
        after_words[list_words] = {Words(meeting.after[0]), Words(meeting.after[1])};
    const std::uint32_t surfaces = bits(by_surface);
    for (std::uint32_t left = bits(dressed); left; left &= left - 1) {
        const std::size_t lane = std::size_t(__builtin_ctz(left));
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
        surface.rank_before = int(before[lane]);
        surface.rank_after = int(after[lane]);
        for (int w = 0; w < list_words; ++w) {
            surface.before[std::size_t(w)] = before_words[w][lane];
            surface.after[std::size_t(w)] = after_words[w][lane];
        }
        surface.contacts = contacts[lane];
        surface.sphere_contacts = meeting.sphere_contacts[lane];
        surface.magnitude = magnitudes[lane];
        surface.level = int(levels[lane]);
        add_light(surface.ray.code, host_.shade(surface, stack_));
    }
}

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
