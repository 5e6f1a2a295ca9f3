// error_soak SCENE...: what --aa says of its error against what it is, at several errors. Exit code
// 1 if one is off by more than a fifth.
#include <fmt/format.h>

#include <cmath>

#include "bench/reference.hpp"
#include "compare/metrics.hpp"
#include "lang/interpret.hpp"
#include "tracer/render.hpp"

using namespace meniscus;

int main(int argc, char** argv) {
    int off = 0;
    for (int i = 1; i < argc; ++i) {
        lang::Options reading;
        tracer::Options options;
        options.width = reading.image_width = 160;
        options.height = reading.image_height = 120;
        const auto scene = tracer::compile(lang::interpret_file(argv[i], reading).scene);
        const auto reference = bench::make_reference(scene, options, 1024);
        fmt::print("{}: reference's own error {:.1e}\n", argv[i], reference.rmse);
        for (const double wanted : {0.05, 0.03, 0.02, 0.01, 0.005}) {
            options.sampling = tracer::ErrorSampling{wanted};
            const auto rendered = tracer::render(scene, options);
            const double seen = compare::measure(reference.picture, rendered.picture, 0.0).rmse;
            // The reference's error is no part of it.
            const double error =
                std::sqrt(std::max(0.0, seen * seen - reference.rmse * reference.rmse));
            const double estimated = rendered.estimated_error.value();
            const double ratio = error / estimated;
            const bool is_honest = ratio > 0.8 && ratio < 1.2;
            off += !is_honest;
            fmt::print("  --aa {:<6} estimated {:.2e}, reached {:.2e}: {:.2f}{}\n", wanted,
                       estimated, error, ratio, is_honest ? "" : "  OFF");
        }
    }
    return off == 0 ? 0 : 1;
}
