#pragma once

#include <catch2/catch.hpp>

#include "compare/metrics.hpp"
#include "tracer/render.hpp"

namespace meniscus::test {

/// A small picture, every branch of its ray trees.
inline tracer::Options full_trees(tracer::Kernel kernel) {
    tracer::Options options;
    options.width = 40;
    options.height = 30;
    options.sampling = tracer::CountSampling{4};
    options.tree = tracer::Tree::full;
    options.depth = 40;
    options.cutoff = 1e-3;
    options.kernel = kernel;
    return options;
}

/// What a compiled scene knows to be spared work changes no picture and no count: rendered with it,
/// and once more after `forget(scene)`.
template <class Forget>
void check_shortcut(tracer::RenderScene scene, Forget forget) {
    const auto options = full_trees(tracer::Kernel::general);
    const auto with = tracer::render(scene, options);
    forget(scene);
    const auto without = tracer::render(scene, options);
    CHECK(compare::measure(with.picture, without.picture, 0.0).largest == 0.0);
    CHECK(with.statistics.segments == without.statistics.segments);
    CHECK(with.statistics.true_crossings == without.statistics.true_crossings);
    CHECK(with.statistics.false_crossings == without.statistics.false_crossings);
    CHECK(with.statistics.leaks == 0);
    CHECK(without.statistics.leaks == 0);
}

}  // namespace meniscus::test
