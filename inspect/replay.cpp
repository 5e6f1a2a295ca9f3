#include "inspect/replay.hpp"

#include "inspect/reason.hpp"

namespace meniscus::inspect {
namespace {

using tracer::InteriorList;
using tracer::InteriorMode;
using tracer::Judged;

/// As the tracer does it, the paper's toggling included.
void apply(const tracer::RenderScene& scene, InteriorMode mode, const Judged& crossing,
           InteriorList& list) {
    const tracer::Part& part = scene.parts[std::size_t(crossing.part)];
    if (!part.is_member || mode == InteriorMode::off) return;
    const bool enters =
        mode == InteriorMode::recast ? !list.inside(crossing.part) : crossing.entering;
    if (enters) {
        list.enter(crossing.part);
    } else if (list.inside(crossing.part) || part.inverse) {
        list.leave(crossing.part);
    }
}

}  // namespace

std::vector<Step> replay(const tracer::RenderScene& scene, const Names& names,
                         const tracer::TreeNode& node, InteriorMode mode) {
    InteriorList list = node.start.interior;
    std::vector<Step> steps;
    const std::vector<Judged>& crossings = node.crossings;
    std::size_t next = 0;
    while (next < crossings.size()) {
        Step step;
        step.is_true = crossings[next].is_true;
        step.before = listing(scene, list);
        // All true crossings of a segment are its one event. A false crossing that changes what is
        // there belongs together with those that change it back.
        do {
            apply(scene, mode, crossings[next], list);
            step.crossings.push_back(crossings[next++]);
            step.after = listing(scene, list);
        } while (next < crossings.size() && step.is_true == crossings[next].is_true &&
                 (step.is_true || step.after.top != step.before.top));
        if (step.is_true && mode == InteriorMode::off) {
            step.before = listing(scene, node.event.before);
            step.after = listing(scene, node.event.after);
        }
        for (const Judged& crossing : step.crossings) {
            step.why.push_back(step.is_true ? why_true(scene, names, crossing, step, node.event)
                                            : why_false(scene, names, crossing, step));
        }
        steps.push_back(std::move(step));
    }
    return steps;
}

}  // namespace meniscus::inspect
