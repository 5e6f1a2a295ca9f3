#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "lanes/kernel.hpp"
#include "tracer/ahead.hpp"
#include "tracer/ray_tree.hpp"
#include "tracer/samples.hpp"

namespace meniscus::tracer {

/// Gives the kernel for lanes what it asks for: camera rays, skies, textures and lights, and the
/// general way for rays that are too close to call. One for each thread.
class LaneHost final : public lanes::Host {
public:
    LaneHost(const RenderScene& scene, const Options& options, const lanes::Program& program,
             RayTree& tree, Statistics& statistics);

    /// Adds some samples that are to be followed next, none when there are no more.
    using MoreSamples = std::function<void(std::vector<Sample>& out)>;
    /// Follows samples; the light of each goes to `sums()` at 4 * sample.target: red, green, blue
    /// in 1 / program.units, times the sample's weight.
    void run(const MoreSamples& more, std::size_t targets);
    const std::vector<std::int64_t>& sums() const { return sums_; }

    const lanes::Camera* camera() const override { return camera_ ? &*camera_ : nullptr; }
    std::size_t more_points(lanes::FilmPoints& points, std::size_t wanted) override;
    void more_rays(lanes::Stacks& stacks, std::size_t wanted) override;
    geom::Vec3 sky(const geom::Vec3& direction, int rank) override;
    geom::Vec3 transmittance(int rank, double way, bool of_shadow) override;
    geom::Vec3 shade(const lanes::Surface& surface, lanes::Stacks& stacks) override;
    geom::Interval interval(const lanes::Solid& solid, const geom::Ray& ray,
                            geom::Face pin) override;
    int crossings(const lanes::Solid& solid, const geom::Ray& ray, lanes::Met* out) override;
    void meet_mesh(const lanes::Solid& solid, std::span<const lanes::MeshRay> rays,
                   lanes::MeshMet* met) override;
    geom::Vec3 put_on_face(const lanes::Solid& solid, geom::Face face, geom::Vec3& point) override;
    geom::Vec3 follow(const lanes::WaitingRay& ray) override;

private:
    const scene::Interior& medium_at(int rank) const;
    bool is_bit(const lanes::Places& words, int place) const {
        return (words[std::size_t(place / 64)] >> (place % 64) & 1u) != 0;
    }
    void add_contacts(const lanes::WaitingRay& ray, TracedRay& traced) const;
    void list_start(const TracedRay& start, lanes::WaitingRay& ray) const;
    scene::Rgb pass_shadow(const lanes::Surface& surface, lanes::RayStack& stack);
    bool is_camera_in_the_open() const;
    bool is_tied(const lanes::Places& inside) const;
    void add_light(const Sample& sample, const scene::Rgb& light);
    std::size_t samples_at_hand();

    const RenderScene& scene_;
    const Options& options_;
    const lanes::Program& program_;
    RayTree& tree_;
    Statistics& statistics_;
    lanes::Stacks stacks_;
    std::vector<std::int64_t> sums_;
    std::vector<int> rank_of_part_;
    const MoreSamples* more_ = nullptr;
    std::vector<Sample> samples_;  // the next ones
    std::size_t next_sample_ = 0;
    std::optional<lanes::Camera> camera_;  // if every camera ray starts in one place with one list
    Shading shading_;
    geom::Crossings crossings_;
    /// Of rays that are asked about together.
    struct MeshStart {
        KnownStart known;
        geom::Crossing own;
    };
    std::vector<geom::SearchedRay> searched_;
    std::vector<MeshStart> starts_;
};

}  // namespace meniscus::tracer
