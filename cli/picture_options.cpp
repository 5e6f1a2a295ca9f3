#include "cli/picture_options.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/exit_code.hpp"
#include "tracer/film.hpp"

namespace meniscus::cli {
namespace {

image::Format choose_format(const PictureOptions& options) {
    if (options.format == "png") return image::Format::png;
    if (options.format == "exr") return image::Format::exr;
    if (options.output.empty()) return image::Format::png;
    if (const auto format = image::format_of(options.output)) return *format;
    throw UsageError(
        fmt::format("'{}' ends in neither .png nor .exr; --format says which", options.output));
}

std::filesystem::path choose_path(const PictureOptions& options, const std::string& stem,
                                  image::Format format) {
    if (!options.output.empty()) return options.output;
    return stem + (format == image::Format::exr ? ".exr" : ".png");
}

std::vector<std::string> choose_layers(const std::vector<std::string>& asked) {
    const auto known = tracer::layer_names();
    bool all = false;
    for (const auto& name : asked) {
        all |= name == "all";
        if (name != "all" && std::ranges::find(known, name) == known.end())
            throw UsageError(fmt::format("--layers: there is no '{}'; there are all, {}", name,
                                         fmt::join(known, ", ")));
    }
    return all ? known : asked;
}

}  // namespace

void add_picture_options(CLI::App& app, PictureOptions& o) {
    const auto last = CLI::MultiOptionPolicy::TakeLast;
    app.add_option("-o,--output", o.output,
                   "Default: SCENE.png in the working directory; - is standard output")
        ->multi_option_policy(last)
        ->type_name("OUT.png|OUT.exr|-")
        ->group("Picture");
    app.add_option("--format", o.format, "png or exr; default: by the output's extension")
        ->check(CLI::IsMember({"png", "exr"}))
        ->multi_option_policy(last)
        ->type_name("FORMAT")
        ->group("Picture");
    app.add_option("--bits", o.bits, "Bits a channel of a PNG, 8 or 16")
        ->check(CLI::IsMember({8, 16}))
        ->multi_option_policy(last)
        ->type_name("N")
        ->group("Picture");
    app.add_option("--encoding", o.encoding, "Of a PNG: srgb or linear; default: as the scene asks")
        ->check(CLI::IsMember({"srgb", "linear"}))
        ->multi_option_policy(last)
        ->type_name("ENCODING")
        ->group("Picture");
    app.add_flag("--half", o.half, "OpenEXR: colours as 16-bit floats")->group("Picture");
    app.add_option(
           "--layers", o.layers,
           fmt::format("OpenEXR: the extra layers to add, with commas between: all, or of {}",
                       fmt::join(tracer::layer_names(), ", ")))
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("LIST")
        ->group("Picture");
}

PictureTarget make_target(const PictureOptions& options, const std::string& stem) {
    PictureTarget target;
    target.save.format = choose_format(options);
    target.path = choose_path(options, stem, target.save.format);
    const bool is_exr = target.save.format == image::Format::exr;
    if (is_exr && options.bits) throw UsageError("--bits is for PNG; OpenEXR has --half");
    if (is_exr && !options.encoding.empty()) throw UsageError("--encoding is for PNG");
    if (!is_exr && options.half) throw UsageError("--half is for OpenEXR; PNG has --bits");
    if (!is_exr && !options.layers.empty()) throw UsageError("--layers needs an .exr picture");
    target.save.png.bits = options.bits.value_or(8);
    if (options.encoding == "linear") target.save.png.encoding = image::Encoding::linear;
    target.save.exr.half = options.half;
    target.layers = choose_layers(options.layers);
    return target;
}

}  // namespace meniscus::cli
