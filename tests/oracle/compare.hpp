#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>

#include "scene/scene.hpp"
#include "tests/oracle/trace.hpp"
#include "tracer/render.hpp"

namespace meniscus::oracle {

struct Picture {
    int width = 48, height = 36;
    Limits limits{.depth = 8, .cutoff = 1e-3};
    tracer::InteriorMode interior = tracer::InteriorMode::sweep;
};

/// What makes the tracer see a picture as the oracle does: pixel centres, the whole ray tree.
tracer::Options options_for(const Picture& picture, int threads = 1);

/// The tracer's picture of the scene.
tracer::Rendered rendered(const scene::Scene& scene, const Picture& picture = {}, int threads = 1);

/// Whether the exact picture (or one between the exact ones, if there are several) jumps over all
/// of the values near a pixel's centre, but for `slack`: that is asked all round, at distances from
/// `reach` widths of the picture down to the rounding of a double.
bool jumps_over(std::initializer_list<const Tracer<Quad>*> oracles, int x, int y,
                const Picture& picture, std::initializer_list<scene::Rgb> values, double slack,
                double reach = 1e-9);

/// How far the tracer's picture is from the oracle's.
struct Difference {
    std::size_t pixels = 0, off = 0, far_off = 0;  // by more than 1e-6, 2e-3 in some channel
    double median = 0.0, largest = 0.0;            // over pixels, of the largest channel
    int worst_x = 0, worst_y = 0;
    /// Pixels off by more than 1e-3 where the exact picture is continuous: nowhere within 1e-9 of
    /// the picture's width does it jump over the value that the tracer found.
    std::size_t unexplained = 0;
    std::uint64_t leaks = 0;
    std::string text() const;
};

/// Rounds the oracle's values to float, as pictures hold them.
template <class Real>
Difference compare(const scene::Scene& scene, const Picture& picture = {});
/// The same, for a picture that the tracer has made already.
template <class Real>
Difference compare(const tracer::Rendered& ours, const scene::Scene& scene,
                   const Picture& picture = {});

/// The same in extended precision, and in quad precision wherever that differs by more than 1e-9
/// from the tracer's: the verdict of quad precision, ten times as fast.
Difference compare_closely(const scene::Scene& scene, const Picture& picture = {});
Difference compare_closely(const tracer::Rendered& ours, const scene::Scene& scene,
                           const Picture& picture = {});

/// How far two pictures of ours are apart that show the same.
struct Change {
    std::size_t off = 0;  // pixels, by more than the bound in some channel
    /// Of these, where the exact picture does not jump over both values (as above).
    std::size_t unexplained = 0;
};

/// `scene` is what both show; its exact picture, in quad precision, is asked where they differ by
/// more than `bound`.
Change change(const tracer::Rendered& a, const tracer::Rendered& b, const scene::Scene& scene,
              const Picture& picture, double bound);

extern template Difference compare<double>(const scene::Scene&, const Picture&);
extern template Difference compare<double>(const tracer::Rendered&, const scene::Scene&,
                                           const Picture&);
extern template Difference compare<Extended>(const scene::Scene&, const Picture&);
extern template Difference compare<Extended>(const tracer::Rendered&, const scene::Scene&,
                                             const Picture&);
extern template Difference compare<Quad>(const scene::Scene&, const Picture&);
extern template Difference compare<Quad>(const tracer::Rendered&, const scene::Scene&,
                                         const Picture&);

}  // namespace meniscus::oracle
