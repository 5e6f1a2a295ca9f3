#pragma once

#include <string>
#include <variant>
#include <vector>

#include "tracer/options.hpp"

namespace meniscus::bench {

/// What stands between solids that touch: nothing, or a film of the outside's medium.
enum class Model { contact, gap };

constexpr const char* name(Model model) { return model == Model::contact ? "contact" : "gap"; }

/// Where POV-Ray's ray tree ends, and ours in Tree::whitted.
struct Limits {
    int max_trace_level = 20;
    double adc_bailout = 1.0 / 255.0;
    bool operator==(const Limits&) const = default;
};

struct ByMeniscus {
    tracer::Options options;  // without the size and threads, which all share
};
struct ByPovRay {
    std::vector<std::string> antialiasing;  // as {"+A0.0", "+AM2", "+R3", "-J"}
};

/// One way to render a scene.
struct Contender {
    std::string curve;    // those of one renderer, model and interior mode share a curve
    std::string options;  // as on the command line, as far as they tell it from its curve's others
    /// The same for contenders of several curves that do the same work; empty: none else does.
    std::string task;
    Model model = Model::contact;
    std::optional<Limits> limits;  // in place of the scene's own
    std::variant<ByMeniscus, ByPovRay> how;

    bool is_povray() const { return std::holds_alternative<ByPovRay>(how); }
};

}  // namespace meniscus::bench
