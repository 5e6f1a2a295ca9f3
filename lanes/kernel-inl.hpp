// The kernel: what it holds, and the stages of a step, each in a file of its own.

#if defined(MENISCUS_LANES_KERNEL) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_KERNEL
#undef MENISCUS_LANES_KERNEL
#else
#define MENISCUS_LANES_KERNEL
#endif

#include <bit>
#include <cmath>

#include "lanes/batch-inl.hpp"
#include "lanes/faces-inl.hpp"
#include "lanes/lathe-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace meniscus::lanes::HWY_NAMESPACE {

/// What the solids are, by index: a number of each for `look_up`, and 0 behind them.
struct Table {
    using Column = double[most_solids + 1];
    alignas(64) Column ior{}, medium{}, magnitude{};
    alignas(64) Column dressed{}, attenuates{};                    // 1: it is
    alignas(64) Column bit[list_words]{};                          // its place, as bits
    alignas(64) Column x{}, y{}, z{}, radius{}, inverse_radius{};  // of plain balls; else 0

    explicit Table(const Program& program) {
        for (std::size_t i = 0; i < program.solids.size(); ++i) {
            const Solid& solid = program.solids[i];
            const bool is_member = solid.rank >= 0;
            const Member& member =
                is_member ? program.members[std::size_t(solid.rank)] : program.outside;
            ior[i] = member.ior;
            medium[i] = member.medium;
            magnitude[i] = solid.magnitude;
            dressed[i] = !member.clear;
            attenuates[i] = member.attenuates;
            if (is_plain_ball(solid)) {
                x[i] = solid.center.x;
                y[i] = solid.center.y;
                z[i] = solid.center.z;
                radius[i] = solid.radius;
                inverse_radius[i] = solid.inverse_radius;
            }
            bit[solid.place / 64][i] = std::bit_cast<double>(1ull << (solid.place % 64));
        }
    }
};

class Kernel {
public:
    Kernel(const Program& program, Host& host, Stacks& stacks, std::int64_t* sums)
        : program_(program), host_(host), stacks_(stacks), sums_(sums), table_(program) {
        for (std::size_t rank = 0; rank < program.members.size(); ++rank) {
            const Member& member = program.members[rank];
            if (member.in_group) group_bits_[rank / 64] |= 1ull << (rank % 64);
            const geom::Vec3& c = member.center;
            magnitudes_.push_back(std::max({std::abs(c.x), std::abs(c.y), std::abs(c.z)}) +
                                  member.radius);
        }
        for (const int i : program.lathes) profiles_.emplace_back(program.solids[std::size_t(i)]);
        for (std::size_t i = 0; i < program.listed_solids; ++i) {
            const auto rank = std::size_t(program.solids[i].rank);
            const Member& member = program.members[rank];
            listed_.push_back({1ull << (rank % 64), rank / 64, member.ior, double(member.medium),
                               member.clear, member.attenuates, has_faces(program.solids[i].kind)});
        }
    }

    Counts run();

private:
    void add_camera_rays();
    void step(RayStack& stack, const Surroundings& around, bool is_shadow);
    HWY_INLINE void take(Batch& batch, RayStack& stack, bool is_shadow);
    HWY_INLINE void approach(Batch& batch, Findings& found);
    HWY_INLINE void approach_shades(Batch& batch, Findings& found);
    HWY_INLINE void approach_ball(Batch& batch, Findings& found, std::size_t i);
    HWY_INLINE void approach_floor(Batch& batch, Findings& found, std::size_t i);
    HWY_INLINE void approach_cylinder(Batch& batch, Findings& found, std::size_t i);
    HWY_INLINE void approach_box(Batch& batch, Findings& found, std::size_t i);
    HWY_INLINE void approach_lathe(Batch& batch, Findings& found, std::size_t i);
    HWY_INLINE void approach_any(Batch& batch, Findings& found, std::size_t i);
    HWY_INLINE void approach_meshes(Batch& batch, Findings& found);
    HWY_INLINE void approach_mesh(Batch& batch, Findings& found, std::size_t i);
    HWY_INLINE void ask_mesh(Batch& batch, const Findings& found, std::size_t i, M which, M hidden);
    HWY_INLINE void doubt_meshes(Batch& batch) const;
    HWY_INLINE F nearest_sure(const Findings& found) const;
    HWY_INLINE F mesh_reach(const Batch& batch, F t) const;
    HWY_INLINE F mesh_slack(const Batch& batch) const;
    HWY_INLINE M sees(const Batch& batch, const Solid& solid) const;
    HWY_INLINE void come_to_span(Batch& batch, Findings& found, const Solid& solid, std::size_t i,
                                 M inside, F t0, F t1, M exists, F face);
    HWY_INLINE void come_to(Batch& batch, Findings& found, const Solid& solid, std::size_t i, F t,
                            F face);
    HWY_NOINLINE void find_stretches(Batch& batch, Findings& found);
    bool ask(Batch& batch, F nearest, std::size_t i);
    HWY_INLINE void meet(Batch& batch, Findings& found, std::size_t i);
    HWY_INLINE void meet_floor(Batch& batch, Findings& found, std::size_t i);
    HWY_INLINE M hidden_from(const Batch& batch, const Solid& solid) const;
    HWY_INLINE void offer(Findings& found, std::size_t i, const Stretch& stretch, M hidden);
    HWY_INLINE Span ask_span(const Batch& batch, const Solid& solid, U contact, M which);
    HWY_INLINE LatheCrossings ask_crossings(const Batch& batch, const Solid& solid, M which,
                                            M& unsure);
    HWY_INLINE void find_small_spheres(Batch& batch, Findings& found);
    HWY_INLINE void own_by_small_spheres(Batch& batch, std::uint32_t which, Medium& owner,
                                         List& bit) const;
    HWY_INLINE void touch_small_spheres(Batch& batch, M which) const;
    HWY_INLINE F nearest_magnitude(const Batch& batch, U index) const;
    void find_event(Batch& batch, const Findings& found);
    HWY_INLINE bool list_event(Batch& batch, const Findings& found);
    HWY_INLINE void change_lists(Batch& batch, const Crossing& nearest);
    HWY_INLINE void change_bits(Batch& batch, const List& bit, const Medium& owner) const;
    template <bool one_word>
    bool count_together(Batch& batch, U nearest);
    HWY_INLINE F bounds_of_event(const Batch& batch, U index, F& pivot) const;
    HWY_INLINE M is_surface(const Batch& batch, U index) const;
    HWY_INLINE M is_in_some(const List& list) const;
    HWY_INLINE Medium medium_of(U index) const;
    HWY_INLINE Medium on_top(const Batch& batch, const List& list) const;
    HWY_INLINE void name_owner(Batch& batch, const Owner& surface) const;
    HWY_INLINE void mark_ties(Batch& batch);
    HWY_INLINE std::uint32_t covered_by_small_spheres(const List& list, Doubles& ranks) const;
    HWY_NOINLINE void make_lists(Batch& batch, U nearest);
    HWY_INLINE void list_small_spheres(Batch& batch, F pivot, F reach, M& torn);
    HWY_INLINE M are_both(const Tie& tie, const List& list) const;
    HWY_INLINE void hand_over(Batch& batch, RayStack& stack);
    HWY_INLINE void count_event(Batch& batch);
    HWY_INLINE void tell_surfaces(Batch& batch);
    HWY_INLINE void attenuate(Batch& batch);
    HWY_INLINE void arrive(const Batch& batch, M gone);
    HWY_INLINE void put_on_faces(Batch& batch);
    HWY_INLINE void put_on_balls(const Batch& batch, M here, FacePoint& all,
                                 F& owner_magnitude) const;
    HWY_INLINE void put_on_lathes(const Batch& batch, M here, FacePoint& all) const;
    HWY_INLINE FacePoint ask_face(const Solid& solid, M which, const F3& point, F face);
    HWY_INLINE void add_small_spheres(const Batch& batch, M met, Round& round,
                                      F& owner_magnitude) const;
    HWY_INLINE void pass(Batch& batch, M which);
    HWY_INLINE void split(Batch& batch);
    HWY_INLINE void paint(const Batch& batch);
    HWY_INLINE void dress(const Batch& batch);
    HWY_INLINE void push(RayStack& stack, const Batch& batch, M which, const Child& child,
                         const List& list, bool is_shadow);
    HWY_INLINE void push_by_place(const Batch& batch, M which, const Child& child,
                                  const List& list);
    WaitingRay waiting(RayStack& stack, std::size_t at, bool is_shadow) const;
    HWY_INLINE void add_light(M which, U code, const F3& light);
    HWY_INLINE void add_light(M which, U code, const PixelLight& light);
    void add_light(std::uint64_t code, const geom::Vec3& light) {
        std::int64_t* sum = sums_ + 4 * (code & RayCode::pixel_mask);
        for (int i = 0; i < 3; ++i) sum[i] += std::int64_t(std::llrint(light[i] * program_.units));
        ++sum[3];
    }
    HWY_INLINE F3 throughput_of(const Batch& batch) const {
        return has_colour(batch.is_shadow) ? batch.throughput
                                           : F3{batch.weight, batch.weight, batch.weight};
    }
    bool has_colour(bool is_shadow) const { return is_shadow || !program_.grey; }
    /// Whether the rays go to lights and meet nothing but what is opaque.
    bool cares_for_shades(const Batch& batch) const {
        return batch.is_shadow && program_.only_opaque_shades;
    }
    bool has_key(bool is_shadow) const { return program_.uses_keys && !is_shadow; }

    const Program& program_;
    Host& host_;
    Stacks& stacks_;
    std::int64_t* sums_;
    Counts counts_;
    Table table_;
    std::vector<Listed> listed_;                 // in the order of their ranks
    FilmPoints points_;                          // of the camera rays that are made
    std::vector<Profile> profiles_;              // of `lathes`
    std::vector<double> magnitudes_;             // of grouped spheres, by rank
    std::uint64_t group_bits_[list_words] = {};  // their places
};

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
