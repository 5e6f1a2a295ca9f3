// The kernel: what it holds, and the stages of a step, each in a file of its own.

#if defined(MENISCUS_LANES_KERNEL) == defined(HWY_TARGET_TOGGLE)
#ifdef MENISCUS_LANES_KERNEL
#undef MENISCUS_LANES_KERNEL
#else
#define MENISCUS_LANES_KERNEL
#endif

#include <cmath>

#include "lanes/batch-inl.hpp"
#include "lanes/faces-inl.hpp"
#include "lanes/lathe-inl.hpp"

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
    HWY_INLINE void find_event(Batch& batch, Top& before, Top& after);
    template <bool exact>
    HWY_INLINE bool make_lists(Batch& batch, Top& before, Top& after);
    template <bool exact>
    HWY_INLINE M list_small_spheres(Batch& batch, F low_bound, F high_bound, F pivot, F reach,
                                    M crossed, M& torn, Top& before, Top& after);
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
    // How often crossings lay together of late: steps to go without trying a coarse bound first.
    static constexpr int crowded_cost = 8, most_crowded = 16;
    int crowded_ = 0;
    std::vector<double> magnitudes_;             // of grouped spheres, by rank
    std::uint64_t group_bits_[list_words] = {};  // their places
};

}  // namespace meniscus::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
