#include "tracer/options.hpp"

namespace meniscus::tracer {

Tree implied_tree(const Options& options) {
    if (options.tree) return *options.tree;
    if (std::holds_alternative<GridSampling>(options.sampling)) return Tree::whitted;
    if (std::holds_alternative<ContrastSampling>(options.sampling)) return Tree::whitted;
    const auto* count = std::get_if<CountSampling>(&options.sampling);
    return count && count->samples == 1 ? Tree::whitted : Tree::sampled;
}

std::string_view name(InteriorMode mode) {
    switch (mode) {
        case InteriorMode::sweep:
            return "sweep";
        case InteriorMode::recast:
            return "recast";
        case InteriorMode::off:
            return "off";
    }
    return "";
}

std::string_view name(Tree tree) {
    switch (tree) {
        case Tree::whitted:
            return "whitted";
        case Tree::full:
            return "full";
        case Tree::sampled:
            return "sampled";
    }
    return "";
}

}  // namespace meniscus::tracer
