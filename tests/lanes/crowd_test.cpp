// Scenes in which much is in each other, so that lanes leave out most of it for most rays: they
// make the pictures of the general way, which leaves out nothing.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "tests/random/random.hpp"
#include "tests/tracer/scenes.hpp"
#include "tests/tracer/shortcut.hpp"
#include "tracer/render.hpp"

using namespace meniscus;
using namespace meniscus::test;

namespace {

class Crowd {
public:
    explicit Crowd(std::uint64_t seed) : random_(seed) {
        look(scene_, {0.7, 1.1, -5.0});
        scene_.background.rgb = scene::Rgb{0.2, 0.5, 0.9};
        for (int i = 0; i < 40; ++i) priorities_.push_back(i);
        for (std::size_t i = priorities_.size(); --i > 0;)
            std::swap(priorities_[i], priorities_[std::size_t(random_.below(int(i) + 1))]);
        gap_ = std::vector{0.0, 1e-9, 1e-5, 0.03}[std::size_t(random_.below(4))];
        switch (seed % 5) {
            case 0:
                add_balls_in_balls();
                break;
            case 1:
                add_cup();
                break;
            case 2:
                add_drops();
                break;
            case 3:
                add_boxes_in_boxes();
                break;
            default:
                add_cylinders_in_cylinders();
        }
        if (random_.chance(0.4)) {
            const double priority = next_priority();
            for (int i = 0; i < 20; ++i)
                add_glass(scene_,
                          geom::Sphere{random_.point(-0.7, 0.7), random_.between(0.02, 0.1)}, 1.0,
                          priority);
        }
        if (random_.chance(0.4))
            add_opaque(scene_, geom::Sphere{random_.point(-0.5, 0.5), random_.between(0.1, 0.3)},
                       matte(plain(scene::Rgb{0.9, 0.2, 0.1})));
        if (random_.chance(0.7))
            add_opaque(scene_, geom::Plane{{0.0, 1.0, 0.0}, random_.chance(0.5) ? -1.0 : -1.2},
                       emissive(checker(scene::Rgb{0.2}, scene::Rgb{0.9})));
        if (random_.chance(0.2)) look(scene_, {0.1, 0.2, -0.05});  // from within
    }

    const scene::Scene& scene() const { return scene_; }

private:
    double next_priority() {
        const double priority = priorities_.back();
        priorities_.pop_back();
        return priority;
    }
    void add(geom::Shape shape) {
        constexpr double iors[] = {1.0, 1.1, 1.31, 1.33, 1.5, 2.4};
        add_glass(scene_, std::move(shape), iors[random_.below(6)], next_priority());
    }

    void add_balls_in_balls() {
        double radius = 1.0;
        Vec3 center{0.0};
        for (int i = random_.below(5) + 2; i > 0; --i) {
            add(geom::Sphere{center, radius});
            const double smaller = radius * random_.between(0.4, 0.95), room = radius - smaller;
            const double shift =
                std::vector{0.0, room, std::max(0.0, room - gap_),
                            room * random_.between(0.0, 1.0)}[std::size_t(random_.below(4))];
            center += Random::along(random_.below(3), random_.chance(0.5) ? shift : -shift);
            radius = smaller;
        }
    }

    void add_cup() {
        add(geom::Lathe(geom::Spline::linear,
                        {{0, -1}, {0.8, -1}, {0.8, 1}, {0.7, 1}, {0.7, -0.8}, {0, -0.8}, {0, -1}}));
        if (random_.chance(0.7))
            add(geom::Cylinder{{0.0, -0.8 + gap_, 0.0},
                               {0.0, random_.between(0.0, 1.2), 0.0},
                               0.7 - (random_.chance(0.5) ? gap_ : -0.05)});
        for (int i = random_.below(4); i > 0; --i) {
            const double r = random_.between(0.05, 0.3);
            const double x = random_.chance(0.5) ? 0.7 - r - gap_ : random_.between(0.0, 0.6);
            const double y = random_.chance(0.5) ? -0.8 + r + gap_ : random_.between(-0.7, 1.2);
            add(geom::Sphere{{x, y, 0.0}, r});
        }
        if (random_.chance(0.5)) {
            add(geom::Box{Vec3{-0.2}, Vec3{0.2}});
            scene_.objects.back().transform = geom::Transform::translation(
                {random_.between(0.0, 0.5), random_.between(-0.6, 1.0), 0.0});
        }
        if (random_.chance(0.4)) add(geom::Torus{0.4, 0.1});
    }

    /// Small spheres of one priority that hold, or nearly, what is weaker or stronger.
    void add_drops() {
        const double drop = next_priority();
        for (int i = 0; i < 9; ++i) {
            const Vec3 center = random_.point(-1.5, 1.5);
            const double radius = random_.between(0.15, 0.3);
            add_glass(scene_, geom::Sphere{center, radius}, 1.33, drop);
            const Vec3 within = center + random_.point(-0.1, 0.1);
            const double half = radius * random_.between(0.3, 1.2);
            switch (random_.below(5)) {
                case 0:
                    add(geom::Box{within - half, within + half});
                    break;
                case 1:
                    add(geom::Cylinder{within - Vec3{0.0, half, 0.0}, within + Vec3{0.0, half, 0.0},
                                       0.5 * half});
                    break;
                case 2:
                    add(geom::Sphere{within, half});
                    break;
                default:
                    break;
            }
        }
        if (random_.chance(0.5)) add(geom::Box{Vec3{-1.0}, Vec3{1.0}});
    }

    void add_boxes_in_boxes() {
        double half = 1.0;
        for (int i = random_.below(4) + 2; i > 0; --i) {
            add(geom::Box{Vec3{-half}, Vec3{half}});
            half -= random_.chance(0.3) ? gap_ : random_.between(0.05, 0.2);
        }
        add(geom::Sphere{{random_.between(-1.0, 1.0), random_.between(-1.0, 1.0), 1.0},
                         random_.between(0.2, 0.9)});
    }

    void add_cylinders_in_cylinders() {
        double half = 1.0;
        for (int i = random_.below(4) + 2; i > 0; --i) {
            const double top = half + (random_.chance(0.5) ? 0.2 : 0.0);
            add(geom::Cylinder{{0.0, -half, 0.0}, {0.0, top, 0.0}, half});
            half -= random_.chance(0.3) ? gap_ : random_.between(0.05, 0.2);
        }
        add(geom::Cone{{0.0, -0.5, 0.0},
                       random_.between(0.1, 0.9),
                       {0.0, 0.5, 0.0},
                       random_.between(0.0, 0.4)});
    }

    Random random_;
    scene::Scene scene_;
    std::vector<int> priorities_;
    double gap_ = 0.0;
};

}  // namespace

TEST_CASE("in crowds lanes make the pictures of the general way", "[lanes]") {
    std::size_t in_lanes = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const auto scene = tracer::compile(Crowd(seed).scene());
        auto options = full_trees(tracer::Kernel::automatic);
        options.sampling = tracer::GridSampling{1};
        options.depth = 12;
        const auto fast = tracer::render(scene, options);
        if (!fast.why_general.empty()) continue;
        ++in_lanes;
        options.kernel = tracer::Kernel::general;
        const auto sure = tracer::render(scene, options);
        INFO("seed " << seed);
        CHECK(compare::measure(sure.picture, fast.picture, 0.0).largest < 1e-6);
        CHECK(fast.statistics.leaks == 0);
    }
    CHECK(in_lanes > 150);
}
