#include "tests/oracle/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace meniscus::oracle {

tracer::Rendered rendered(const scene::Scene& scene, const Picture& picture, int threads) {
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
    return tracer::render(tracer::compile(scene), options);
}

std::string Difference::text() const {
    return fmt::format(
        "{} of {} pixels off by 1e-6, {} by 2e-3; median {:.2g}, largest {:.2g} at ({}, {}); {} "
        "leaks",
        off, pixels, far_off, median, largest, worst_x, worst_y, leaks);
}

template <class Real>
Difference compare(const scene::Scene& scene, const Picture& picture) {
    const auto ours = rendered(scene, picture);
    const Tracer<Real> oracle(scene, picture.limits);
    Difference result;
    result.leaks = ours.statistics.leaks;
    std::vector<double> differences;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const scene::Rgb truth = oracle.pixel(x, y, picture.width, picture.height);
            double difference = 0.0;
            for (int c = 0; c < 3; ++c) {
                const double channel =
                    std::abs(double(ours.picture.pixel(x, y)[c]) - double(float(truth[c])));
                if (!(channel <= difference)) difference = channel;  // NaN too
            }
            differences.push_back(difference);
            if (!(difference <= 1e-6)) ++result.off;
            if (!(difference <= 2e-3)) ++result.far_off;
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

template Difference compare<double>(const scene::Scene&, const Picture&);
template Difference compare<Extended>(const scene::Scene&, const Picture&);
template Difference compare<Quad>(const scene::Scene&, const Picture&);

}  // namespace meniscus::oracle
