#include "bench/measure.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "povray/export.hpp"
#include "povray/film.hpp"

namespace meniscus::bench {
namespace {

/// A scene as one model has it, and what was last made of it.
class Subject {
public:
    Subject(const Setup& setup, Model model) : model_(model), scene_(scene_of(setup, model)) {}

    const tracer::RenderScene& compiled(const std::optional<Limits>& limits,
                                        tracer::InteriorMode mode) {
        const auto hidden = tracer::hidden_in(mode);
        if (!compiled_ || compiled_limits_ != limits || compiled_hidden_ != hidden) {
            compiled_.reset();
            compiled_ = tracer::compile(with(scene_, limits), hidden);
            compiled_limits_ = limits;
            compiled_hidden_ = hidden;
        }
        return *compiled_;
    }

    /// The scene for POV-Ray, which makes its films by CSG.
    const std::string& exported(const Setup& setup, const std::optional<Limits>& limits) {
        if (exported_.empty() || exported_limits_ != limits) {
            povray::ExportOptions options;
            options.model = model_ == Model::gap ? povray::Model::gap : povray::Model::contact;
            options.gap = model_ == Model::gap ? setup.gap : 0.0;
            options.scale = setup.scale;
            options.source = setup.name;
            exported_ = povray::export_scene(with(setup.scene, limits), options).text;
            exported_limits_ = limits;
        }
        return exported_;
    }

private:
    static scene::Scene scene_of(const Setup& setup, Model model) {
        if (model == Model::contact) return setup.scene;
        return setup.gap_scene ? *setup.gap_scene
                               : povray::with_films(setup.scene, setup.gap).scene;
    }
    static scene::Scene with(scene::Scene scene, const std::optional<Limits>& limits) {
        if (limits) {
            scene.settings.max_trace_level = limits->max_trace_level;
            scene.settings.adc_bailout = limits->adc_bailout;
        }
        return scene;
    }

    Model model_;
    scene::Scene scene_;
    std::optional<tracer::RenderScene> compiled_;
    std::string exported_;
    std::optional<Limits> compiled_limits_, exported_limits_;
    tracer::Hidden compiled_hidden_{};
};

void clip(image::Image& picture) {
    for (float& value : picture.rgb) value = std::clamp(value, 0.0f, 1.0f);
}

class Measurer {
public:
    explicit Measurer(const Setup& setup) : setup_(setup) {
        result_.scene = setup.name;
        result_.width = setup.width;
        result_.height = setup.height;
        result_.threads = setup.threads;
        result_.gap = setup.gap;
        for (auto& contender : make_contenders(setup.sweep)) {
            result_.is_clipped = result_.is_clipped || setup.clip || contender.is_povray();
            result_.rows.push_back({std::move(contender), {}, {}, {}, {}, 0.0, false, {}});
        }
    }

    Result run() {
        make_references();
        for (int round = 0; round < setup_.runs; ++round)
            for (auto& row : result_.rows) run_once(row, round);
        result_.is_interrupted = is_interrupted();
        std::erase_if(result_.rows,
                      [](const Row& row) { return row.seconds.empty() && row.failure.empty(); });
        mark_fronts(result_);
        return std::move(result_);
    }

private:
    bool is_interrupted() const { return setup_.interrupted && setup_.interrupted->load(); }
    void say(const std::string& line) const {
        if (setup_.say) setup_.say(line);
    }

    Subject& subject(Model model) {
        return subjects_.try_emplace(model, setup_, model).first->second;
    }

    void make_references() {
        for (const auto model : setup_.sweep.models) {
            if (is_interrupted()) return;
            say(fmt::format("reference, {}: two halves of {} samples a pixel", name(model),
                            setup_.reference_samples));
            tracer::Options options = shared_options();
            options.depth = setup_.sweep.depth;
            auto reference = make_reference(subject(model).compiled({}, options.interior), options,
                                            setup_.reference_samples);
            if (!reference.is_complete) return;
            if (result_.is_clipped) clip(reference.picture);
            say(fmt::format("    its own error {:.2e}", reference.rmse));
            result_.references.emplace(model, std::move(reference));
        }
    }

    tracer::Options shared_options() const {
        tracer::Options options;
        options.interrupted = setup_.interrupted;
        options.width = setup_.width;
        options.height = setup_.height;
        return options;
    }

    void run_once(Row& row, int round) {
        if (is_interrupted() || !row.failure.empty()) return;
        if (const auto* ours = std::get_if<ByMeniscus>(&row.contender.how))
            render(row, *ours);
        else
            render(row, std::get<ByPovRay>(row.contender.how));
        if (is_interrupted()) return;
        const auto number = &row - result_.rows.data() + 1;
        const auto place = fmt::format("{}/{}{}", number, result_.rows.size(),
                                       round > 0 ? fmt::format(", run {}", round + 1) : "");
        if (!row.failure.empty())
            say(fmt::format("[{}] {} {}: {}", place, row.contender.curve, row.contender.options,
                            row.failure));
        else
            say(fmt::format("[{}] {} {}: RMSE {:.2e}, {:.3f} s", place, row.contender.curve,
                            row.contender.options, row.error.rmse, row.seconds.back()));
    }

    void render(Row& row, const ByMeniscus& how) {
        const auto shared = shared_options();
        auto options = how.options;
        options.width = shared.width;
        options.height = shared.height;
        options.interrupted = shared.interrupted;
        options.threads = setup_.threads;
        const auto& scene =
            subject(row.contender.model).compiled(row.contender.limits, options.interior);
        tracer::Rendered rendered;
        repeat_short(row, [&] {
            rendered = tracer::render(scene, options);
            return rendered.interrupted ? std::nullopt : std::optional(rendered.cpu_seconds);
        });
        if (rendered.interrupted) return;
        row.counts = std::move(rendered.statistics);
        row.estimated_error = rendered.estimated_error;
        row.kernel = rendered.why_general.empty() ? "lanes" : "general: " + rendered.why_general;
        judge(row, std::move(rendered.picture));
    }

    void render(Row& row, const ByPovRay& how) try {
        povray::RunOptions options{.width = setup_.width,
                                   .height = setup_.height,
                                   .antialiasing = how.antialiasing,
                                   .threads = setup_.threads};
        povray::Run run;
        const auto source = setup_.povray_sources.find(row.contender.model);
        if (source == setup_.povray_sources.end()) {
            run = povray::run_text(
                subject(row.contender.model).exported(setup_, row.contender.limits), options);
        } else {
            options.declares = source->second.declares;
            options.declares.emplace_back("MTL",
                                          std::to_string(row.contender.limits->max_trace_level));
            options.declares.emplace_back("ADC",
                                          fmt::format("{}", row.contender.limits->adc_bailout));
            options.library_paths = source->second.library_paths;
            run = povray::run(source->second.file, options);
        }
        row.seconds.push_back(run.cpu_seconds);
        judge(row, std::move(run.picture));
    } catch (const povray::RunFailed& error) {
        // Ctrl-C reaches POV-Ray as well.
        if (!is_interrupted()) row.failure = error.what();
    }

    /// What is over in a blink is done a few times at once, and its median counts: the first time
    /// it finds nothing in the caches after what went before. (POV-Ray has a process of its own.)
    template <class Render>
    void repeat_short(Row& row, Render&& render) {
        constexpr double long_enough = 0.2;  // seconds
        constexpr std::size_t most = 5;
        std::vector<double> times;
        for (double sum = 0.0; times.size() < most && sum < long_enough; sum += times.back()) {
            const std::optional<double> seconds = render();
            if (!seconds) return;
            times.push_back(*seconds);
        }
        row.seconds.push_back(median(std::move(times)));
    }

    /// The picture's error; each time it is the same.
    void judge(Row& row, image::Image picture) {
        if (row.seconds.size() > 1) return;
        if (result_.is_clipped) clip(picture);
        row.error =
            compare::measure(result_.references.at(row.contender.model).picture, picture, 0.01);
    }

    const Setup& setup_;
    Result result_;
    std::map<Model, Subject> subjects_;
};

}  // namespace

void check(const Setup& setup, Model model) {
    Subject subject(setup, model);
    if (setup.sweep.povray && !setup.povray_sources.contains(model)) subject.exported(setup, {});
}

Result measure(const Setup& setup) { return Measurer(setup).run(); }

}  // namespace meniscus::bench
