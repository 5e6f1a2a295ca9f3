// Faults planted in what the kernel for lanes is told of a scene, by its tables or by its host:
// they are counted as leaks, or handed to the general way before they do harm.

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <variant>

#include "lanes/kernel.hpp"
#include "tests/oracle/compare.hpp"
#include "tests/oracle/scene_builder.hpp"
#include "tracer/camera_rays.hpp"
#include "tracer/lane_host.hpp"
#include "tracer/lane_program.hpp"

using namespace meniscus;
using namespace meniscus::oracle;

namespace {

constexpr int outer = 0;  // the object that is told of wrongly

enum class Fault { none, missed_solid, missed_crossing, flipped_sign };

/// Hands everything on to the tracer's own host, but for one answer in 97 about solids that the
/// kernel has no code for. Those that are missed lie ahead: else the list has the last word anyway.
class FaultyHost final : public lanes::Host {
public:
    FaultyHost(const tracer::RenderScene& scene, const tracer::Options& options,
               const lanes::Program& program, Fault fault)
        : scene_(scene), options_(options), program_(program), fault_(fault) {}

    tracer::Statistics statistics;
    int planted = 0;
    std::uint64_t handed_over = 0;
    std::vector<std::int64_t> sums;

    void run() {
        sums.assign(4 * std::size_t(options_.width) * std::size_t(options_.height), 0);
        lanes::Stacks stacks(program_);
        handed_over = lanes::run(program_, *this, stacks, sums.data()).handed_over;
    }

    void more_rays(lanes::Stacks& stacks, std::size_t wanted) override {
        for (; wanted > 0 && next_ < options_.width * options_.height; ++next_, --wanted) {
            const auto start = tree_.events().start(
                tracer::camera_ray(scene_.source.camera, next_ % options_.width + 0.5,
                                   next_ / options_.width + 0.5, options_.width, options_.height),
                tracer::RayKind::image);
            lanes::WaitingRay ray;  // in the open: its list is empty
            ray.origin = start.ray.origin;
            ray.direction = start.ray.direction;
            ray.throughput = scene::Rgb{1.0};
            ray.birth_magnitude = start.birth.magnitude;
            ray.code = std::uint64_t(next_);
            stacks.bin_of(ray.inside).push(ray);
        }
    }
    geom::Vec3 sky(const geom::Vec3& direction, int rank) override {
        return host_.sky(direction, rank);
    }
    geom::Vec3 transmittance(int rank, double way, bool of_shadow) override {
        return host_.transmittance(rank, way, of_shadow);
    }
    geom::Vec3 shade(const lanes::Surface& surface, lanes::Stacks& stacks) override {
        return host_.shade(surface, stacks);
    }
    geom::Interval interval(const lanes::Solid& solid, const geom::Ray& ray,
                            geom::Face pin) override {
        geom::Interval interval = host_.interval(solid, ray, pin);
        if (interval.hit && interval.t0 > 1e-6 && is_due(Fault::missed_solid)) interval.hit = false;
        return interval;
    }
    int crossings(const lanes::Solid& solid, const geom::Ray& ray, lanes::Met* out) override {
        const int count = host_.crossings(solid, ray, out);
        if (count <= 0) return count;
        if (out[0].t > 1e-6 && is_due(Fault::missed_solid)) return 0;
        if (is_due(Fault::missed_crossing)) return count - 1;
        if (is_due(Fault::flipped_sign)) out[count - 1].slope *= -1.0;
        return count;
    }
    void meet_mesh(const lanes::Solid& solid, std::span<const lanes::MeshRay> rays,
                   lanes::MeshMet* met) override {
        host_.meet_mesh(solid, rays, met);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            lanes::MeshMet& answer = met[i];
            if (!answer.is_sure || answer.starts_inside || answer.count == 0 ||
                answer.at[0].t <= 1e-6 || !is_due(Fault::missed_solid))
                continue;
            answer.count = 0;
            answer.known = geom::infinity;
        }
    }
    geom::Vec3 put_on_face(const lanes::Solid& solid, geom::Face face, geom::Vec3& point) override {
        return host_.put_on_face(solid, face, point);
    }
    geom::Vec3 follow(const lanes::WaitingRay& ray) override { return host_.follow(ray); }

private:
    bool is_due(Fault fault) {
        constexpr int every = 97;
        if (fault != fault_ || ++calls_ % every != 0) return false;
        ++planted;
        return true;
    }

    const tracer::RenderScene& scene_;
    const tracer::Options& options_;
    const lanes::Program& program_;
    Fault fault_;
    tracer::RayTree tree_{scene_, options_, statistics};
    tracer::LaneHost host_{scene_, options_, program_, tree_, statistics};
    int next_ = 0, calls_ = 0;
};

/// A ball and a box within a solid, the ball partly in the box.
scene::Scene around(const geom::Shape& shape) {
    return SceneBuilder()
        .camera({0.4, 1.3, -6.0}, {0.05, -0.1, 0.0}, 24.0)
        .sky({0.1, 0.1, 0.2}, {0.9, 0.8, 0.7})
        .glass(shape, 1.5, 1)
        .glass(geom::Sphere{{0.05, 0.0, 0.0}, 0.6}, 1.33, 2)
        .glass(geom::Box{{-0.6, -0.4, -0.3}, {0.1, 0.2, 0.3}}, 1.2, 3)
        .scene();
}

const std::vector<geom::Shape> native_shapes{
    geom::Sphere{}, geom::Box{{-0.9, -0.8, -0.7}, {0.9, 0.9, 0.9}},
    geom::Cylinder{{0, -0.9, 0}, {0, 0.9, 0}, 0.9},
    geom::Lathe(geom::Spline::linear, {{0, -0.9}, {0.7, -0.9}, {0.9, 0.9}, {0, 0.9}})};
const geom::Shape cone = geom::Cone{{0, -1, 0}, 1.2, {0, 1.2, 0}, 0.4};
const geom::Shape ring = geom::Torus{0.6, 0.55};
const geom::Shape block = geom::Mesh{};

struct Outcome {
    tracer::Statistics statistics;
    int planted;
    std::uint64_t handed_over;
    std::vector<std::int64_t> sums;
};

/// What comes of a scene whose tables are changed, or whose host errs.
Outcome outcome(const scene::Scene& source, const std::function<void(lanes::Program&)>& change,
                Fault fault = Fault::none) {
    tracer::Options options = options_for({.width = 96, .height = 72});
    options.check_segments = false;
    const auto scene = tracer::compile(source);
    auto program = tracer::make_lane_program(scene, options);
    REQUIRE(std::holds_alternative<lanes::Program>(program));
    change(std::get<lanes::Program>(program));
    FaultyHost host(scene, options, std::get<lanes::Program>(program), fault);
    host.run();
    return {host.statistics, host.planted, host.handed_over, host.sums};
}
Outcome outcome(const geom::Shape& shape, Fault fault) {
    return outcome(
        around(shape), [](lanes::Program&) {}, fault);
}

lanes::Solid& solid_of(lanes::Program& program, int object) {
    return *std::ranges::find(program.solids, object, &lanes::Solid::part);
}

/// Some leaks of the outer solid, and none of another.
void check_blamed(const Outcome& found) {
    CHECK(found.statistics.leaks > 20);
    for (const auto& [what, count] : found.statistics.leaks_by_object)
        CHECK(what.first == std::size_t(outer));
}

}  // namespace

TEST_CASE("without a fault there is no leak in lanes", "[lanes][fault]") {
    for (const geom::Shape& shape : {cone, ring, block})
        CHECK(outcome(shape, Fault::none).statistics.leaks == 0);
    for (const geom::Shape& shape : native_shapes)
        CHECK(outcome(shape, Fault::none).statistics.leaks == 0);
}

TEST_CASE("a solid that some rays do not meet in lanes is counted", "[lanes][fault]") {
    for (const geom::Shape& shape : native_shapes) {
        // Rays that were mirrored find themselves inside of what they have not entered.
        const auto found = outcome(around(shape), [](lanes::Program& program) {
            lanes::Solid& solid = solid_of(program, outer);
            solid.to_camera = false;
            // What not all rays meet has no short way of its own.
            solid.way = lanes::Way::any;
            lanes::Surroundings anywhere = program.everything;
            std::erase(anywhere.balls, int(&solid - program.solids.data()));
            if (solid.kind == lanes::Kind::sphere)
                anywhere.others.push_back(int(&solid - program.solids.data()));
            // They come to what is held by it, too.
            for (lanes::Surroundings& bin : program.bins) {
                anywhere.places = bin.places;
                bin = anywhere;
            }
        });
        INFO(geom::keyword(shape));
        check_blamed(found);
    }
}

TEST_CASE("solids that the kernel's host misses are counted", "[lanes][fault]") {
    for (const geom::Shape& shape : {cone, ring, block}) {
        const auto found = outcome(shape, Fault::missed_solid);
        INFO(geom::keyword(shape) << ", " << found.planted << " planted");
        CHECK(found.planted > 20);
        CHECK(found.statistics.leaks * 10 >= std::uint64_t(found.planted));
        CHECK(found.statistics.leaks_by_object.begin()->first.first == std::size_t(outer));
    }
}

TEST_CASE("a face of a lathe that is not there is counted in lanes", "[lanes][fault]") {
    const auto found = outcome(around(native_shapes.back()), [](lanes::Program& program) {
        auto& pieces = solid_of(program, outer).pieces;
        pieces.erase(pieces.begin() + 1);  // its side
    });
    check_blamed(found);
}

TEST_CASE("what does not take turns is handed over in lanes, and does no harm", "[lanes][fault]") {
    // The host leaves out one crossing, or tells its sign wrongly; a face of a lathe looks inwards.
    const auto check_same = [](const Outcome& found, const Outcome& right) {
        CHECK(found.statistics.leaks == 0);
        for (std::size_t i = 0; i < right.sums.size(); ++i) {
            if (i % 4 == 3) continue;  // leaves
            // Both ways are equal to rounding; one unit of light is 2^41 or more.
            CHECK(std::abs(double(found.sums[i] - right.sums[i])) < 0x1p41 * 1e-9);
        }
    };
    const auto right = outcome(ring, Fault::none);
    for (const Fault fault : {Fault::missed_crossing, Fault::flipped_sign}) {
        const auto found = outcome(ring, fault);
        CHECK(found.planted > 20);
        CHECK(found.handed_over >= right.handed_over + std::uint64_t(found.planted) / 2);
        check_same(found, right);
    }
    const auto source = around(native_shapes.back());
    const auto whole = outcome(source, [](lanes::Program&) {});
    const auto turned = outcome(source, [](lanes::Program& program) {
        lanes::Piece& side = solid_of(program, outer).pieces[1];
        REQUIRE((side.a != 0.0 && side.b != 0.0));
        side.a *= -1.0;
        side.b *= -1.0;
        side.c *= -1.0;
    });
    CHECK(turned.handed_over > whole.handed_over + 500);
    check_same(turned, whole);
}
