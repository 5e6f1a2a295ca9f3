#include "bench/sweep.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>

using namespace meniscus::bench;

namespace {

std::size_t count(const std::vector<Contender>& all, const std::string& curve) {
    return std::size_t(std::ranges::count(all, curve, &Contender::curve));
}

}  // namespace

TEST_CASE("every contender is told apart by its curve and its options", "[bench]") {
    for (auto sweep : {quick_sweep(), full_sweep()}) {
        sweep.models = {Model::contact, Model::gap};
        std::set<std::pair<std::string, std::string>> names;
        const auto all = make_contenders(sweep);
        for (const auto& contender : all) names.emplace(contender.curve, contender.options);
        CHECK(names.size() == all.size());
    }
}

TEST_CASE("the full sweep gives POV-Ray every bail-out, depth and method", "[bench]") {
    auto sweep = full_sweep();
    sweep.models = {Model::gap};
    const auto all = make_contenders(sweep);
    CHECK(count(all, "POV-Ray, gap") == 5 * 2 * sweep.antialiasings.size());
    std::set<int> levels;
    std::set<double> bailouts;
    bool methods[2] = {false, false};
    for (const auto& contender : all) {
        if (!contender.is_povray()) continue;
        levels.insert(contender.limits->max_trace_level);
        bailouts.insert(contender.limits->adc_bailout);
        for (const auto& word : std::get<ByPovRay>(contender.how).antialiasing) {
            methods[0] = methods[0] || word == "+AM1";
            methods[1] = methods[1] || word == "+AM2";
        }
    }
    CHECK(levels == std::set{20, 40});
    CHECK(bailouts == std::set{1.0 / 255.0, 2e-3, 1e-3, 3e-4, 1e-4});
    CHECK((methods[0] && methods[1]));
}

TEST_CASE("pixel centres within the same limits are one task for both renderers", "[bench]") {
    auto sweep = quick_sweep();
    sweep.models = {Model::gap};
    std::map<std::string, std::set<bool>> by_task;
    for (const auto& contender : make_contenders(sweep))
        if (contender.task.find("pixel centres") != std::string::npos) {
            by_task[contender.task].insert(contender.is_povray());
            if (const auto* ours = std::get_if<ByMeniscus>(&contender.how))
                CHECK(ours->options.tree == meniscus::tracer::Tree::whitted);
        }
    CHECK(by_task.size() == sweep.limits.size());
    for (const auto& [task, renderers] : by_task) {
        INFO(task);
        CHECK(renderers.size() == 2);
    }
}

TEST_CASE("without POV-Ray there is none", "[bench]") {
    auto sweep = quick_sweep();
    sweep.povray = false;
    for (const auto& contender : make_contenders(sweep)) CHECK_FALSE(contender.is_povray());
}
