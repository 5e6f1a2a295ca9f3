#pragma once

#include <vector>

#include "bench/contender.hpp"

namespace meniscus::bench {

/// Which settings are tried.
struct Sweep {
    std::vector<Model> models = {Model::contact};
    std::vector<tracer::InteriorMode> modes = {tracer::InteriorMode::sweep};
    std::vector<int> samples;    // --spp; 1 is the pixel centre
    std::vector<double> errors;  // --aa
    std::vector<double>
        cutoffs;              // --tree full, at `full_samples` samples and each of `full_depths`
    std::vector<int> depths;  // of --tree full
    int full_samples = 4;
    int depth = 100;  // of all others
    bool povray = true;
    std::vector<Limits> limits;                           // POV-Ray's, and ours at pixel centres
    std::vector<std::vector<std::string>> antialiasings;  // POV-Ray's
};

/// A few minutes' worth.
Sweep quick_sweep();
/// POV-Ray with bail-outs of 1/255, 2e-3, 1e-3, 3e-4 and 1e-4, 20 and 40 levels, both methods of
/// anti-aliasing.
Sweep full_sweep();

/// One after the other as they are to run.
std::vector<Contender> make_contenders(const Sweep& sweep);

}  // namespace meniscus::bench
