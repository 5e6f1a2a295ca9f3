#include "tests/oracle/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

namespace meniscus::oracle {

namespace {

scene::Rgb pixel_of(const tracer::Rendered& ours, int x, int y) {
    const float* rgb = ours.picture.pixel(x, y);
    return {rgb[0], rgb[1], rgb[2]};
}

/// The largest channel's difference of `seen`, which was rounded to float, from the truth.
double difference_of(const scene::Rgb& truth, const scene::Rgb& seen) {
    double difference = 0.0;
    for (int c = 0; c < 3; ++c) {
        const double channel = std::abs(seen[c] - double(float(truth[c])));
        if (!(channel <= difference)) difference = channel;  // NaN too
    }
    return difference;
}

/// `true_pixel(x, y, seen)` is the exact light.
template <class TruePixel>
Difference compare_pixels(const tracer::Rendered& ours, const scene::Scene& scene,
                          const Picture& picture, TruePixel true_pixel) {
    const Tracer<Quad> quad(scene, picture.limits);
    Difference result;
    result.leaks = ours.statistics.leaks;
    std::vector<double> differences;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const scene::Rgb seen = pixel_of(ours, x, y), truth = true_pixel(x, y, seen);
            const double difference = difference_of(truth, seen);
            differences.push_back(difference);
            if (!(difference <= 1e-6)) ++result.off;
            if (!(difference <= 2e-3)) ++result.far_off;
            if (!(difference <= 1e-3) && !jumps_over({&quad}, x, y, picture, {seen}, 1e-3))
                ++result.unexplained;
            if (!(difference <= result.largest)) {
                result.largest = difference;
                result.worst_x = x;
                result.worst_y = y;
            }
        }
    }
    result.pixels = differences.size();
    std::nth_element(differences.begin(), differences.begin() + std::ptrdiff_t(result.pixels / 2),
                     differences.end());
    result.median = differences[result.pixels / 2];
    return result;
}

}  // namespace

bool jumps_over(std::initializer_list<const Tracer<Quad>*> oracles, int x, int y,
                const Picture& picture, std::initializer_list<scene::Rgb> values, double slack,
                double reach) {
    scene::Rgb low{geom::infinity}, high{-geom::infinity};
    const auto spans_all = [&](Quad at_x, Quad at_y) {
        for (const auto* oracle : oracles) {
            const auto light = oracle->sample(at_x, at_y, picture.width, picture.height);
            low = glm::min(low, light);
            high = glm::max(high, light);
        }
        return std::ranges::all_of(values, [&](const scene::Rgb& value) {
            return glm::all(glm::lessThan(low - slack, value)) &&
                   glm::all(glm::lessThan(value, high + slack));
        });
    };
    const Quad middle_x = x + Quad(0.5), middle_y = y + Quad(0.5);
    if (spans_all(middle_x, middle_y)) return true;
    for (double distance = reach; distance > 5e-16; distance /= 4.0) {
        for (int i = 0; i < 12; ++i) {
            const double angle = 0.1 + i * std::acos(-1.0) / 6.0;
            const Quad way = Quad(distance) * Quad(picture.width);
            if (spans_all(middle_x + way * Quad(std::cos(angle)),
                          middle_y + way * Quad(std::sin(angle))))
                return true;
        }
    }
    return false;
}

tracer::Options options_for(const Picture& picture, int threads) {
    tracer::Options options;
    options.width = picture.width;
    options.height = picture.height;
    options.sampling = tracer::GridSampling{1};
    options.tree = tracer::Tree::full;
    options.interior = picture.interior;
    options.depth = picture.limits.depth;
    options.cutoff = picture.limits.cutoff;
    options.threads = threads;
    options.check_segments = picture.interior == tracer::InteriorMode::sweep;
    return options;
}

tracer::Rendered rendered(const scene::Scene& scene, const Picture& picture, int threads) {
    return tracer::render(tracer::compile(scene), options_for(picture, threads));
}

std::string Difference::text() const {
    return fmt::format(
        "{} of {} pixels off by 1e-6, {} by 2e-3, {} by 1e-3 without a reason; median {:.2g}, "
        "largest {:.2g} at ({}, {}); {} leaks",
        off, pixels, far_off, unexplained, median, largest, worst_x, worst_y, leaks);
}

template <class Real>
Difference compare(const scene::Scene& scene, const Picture& picture) {
    return compare<Real>(rendered(scene, picture), scene, picture);
}

template <class Real>
Difference compare(const tracer::Rendered& ours, const scene::Scene& scene,
                   const Picture& picture) {
    const Tracer<Real> oracle(scene, picture.limits);
    return compare_pixels(ours, scene, picture, [&](int x, int y, const scene::Rgb&) {
        return oracle.pixel(x, y, picture.width, picture.height);
    });
}

Difference compare_closely(const scene::Scene& scene, const Picture& picture) {
    return compare_closely(rendered(scene, picture), scene, picture);
}

Difference compare_closely(const tracer::Rendered& ours, const scene::Scene& scene,
                           const Picture& picture) {
    const Tracer<Extended> extended(scene, picture.limits);
    const Tracer<Quad> quad(scene, picture.limits);
    return compare_pixels(ours, scene, picture, [&](int x, int y, const scene::Rgb& seen) {
        const scene::Rgb truth = extended.pixel(x, y, picture.width, picture.height);
        return difference_of(truth, seen) <= 1e-9 ? truth
                                                  : quad.pixel(x, y, picture.width, picture.height);
    });
}

Change change(const tracer::Rendered& a, const tracer::Rendered& b, const scene::Scene& scene,
              const Picture& picture, double bound) {
    const Tracer<Quad> oracle(scene, picture.limits);
    Change result;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const scene::Rgb one = pixel_of(a, x, y), other = pixel_of(b, x, y);
            if (geom::max_abs(one - other) <= bound) continue;
            ++result.off;
            if (!jumps_over({&oracle}, x, y, picture, {one, other}, 0.5 * bound))
                ++result.unexplained;
        }
    }
    return result;
}

template Difference compare<double>(const scene::Scene&, const Picture&);
template Difference compare<double>(const tracer::Rendered&, const scene::Scene&, const Picture&);
template Difference compare<Extended>(const scene::Scene&, const Picture&);
template Difference compare<Extended>(const tracer::Rendered&, const scene::Scene&, const Picture&);
template Difference compare<Quad>(const scene::Scene&, const Picture&);
template Difference compare<Quad>(const tracer::Rendered&, const scene::Scene&, const Picture&);

}  // namespace meniscus::oracle
