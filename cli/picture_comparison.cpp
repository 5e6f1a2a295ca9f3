#include "cli/picture_comparison.hpp"

#include <fmt/format.h>

#include "image/save.hpp"

namespace meniscus::cli {
namespace {

compare::Side load_side(const std::string& path, bool& clip) {
    auto loaded = image::load_with_header(path);
    const bool is_png = loaded.format == image::Format::png;
    clip = clip || is_png;
    compare::Side side{
        .name = path, .picture = std::move(loaded.image), .facts = {}, .command = {}};
    side.facts.emplace_back(
        "format",
        is_png ? fmt::format("PNG, {} bits a channel{}", loaded.bits,
                             loaded.bits == 8 ? ": steps of up to 0.009 in linear light" : "")
               : fmt::format("OpenEXR, {}-bit floats", loaded.bits));
    for (const char* key : {"Software", "Scene", "Options", "Tree", "Reproduce"})
        if (const auto found = loaded.metadata.find(key); found != loaded.metadata.end())
            side.facts.emplace_back(key, found->second);
    return side;
}

}  // namespace

SceneComparison compare_pictures(const std::string& first, const std::string& second,
                                 const compare::Settings& given) {
    auto settings = given;
    auto reference = load_side(first, settings.clip);
    auto picture = load_side(second, settings.clip);
    SceneComparison result{compare::compare(std::move(reference), std::move(picture), settings),
                           {}};
    result.words.settings = {
        {"values", fmt::format("linear light{}", settings.clip ? ", clipped to [0, 1]" : "")}};
    return result;
}

}  // namespace meniscus::cli
