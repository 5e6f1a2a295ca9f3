#include "bench/reference.hpp"

#include <cmath>

#include "compare/metrics.hpp"

namespace meniscus::bench {

Reference make_reference(const tracer::RenderScene& scene, tracer::Options options,
                         int samples_of_half) {
    options.sampling = tracer::CountSampling{samples_of_half};
    options.tree = tracer::Tree::sampled;
    options.threads = 0;
    options.seed = 1;  // pictures that are measured have seed 0
    auto first = tracer::render(scene, options);
    options.seed = 2;
    const auto second = tracer::render(scene, options);

    const auto difference = compare::measure(first.picture, second.picture, 0.0);
    Reference reference;
    reference.samples = 2 * samples_of_half;
    reference.depth = options.depth;
    reference.rmse = 0.5 * difference.rmse;
    reference.bias = 0.5 * std::abs(difference.bias);
    reference.is_complete = !first.interrupted && !second.interrupted;
    reference.picture = std::move(first.picture);
    for (std::size_t i = 0; i < reference.picture.rgb.size(); ++i)
        reference.picture.rgb[i] = 0.5f * (reference.picture.rgb[i] + second.picture.rgb[i]);
    return reference;
}

}  // namespace meniscus::bench
