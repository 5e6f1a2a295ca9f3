#include "inspect/names.hpp"

#include <fmt/format.h>

#include <map>

namespace meniscus::inspect {
namespace {

/// The names of `things`, which have `name` and `location`, told apart where that is needed.
std::vector<std::string> distinct_names(const auto& things, std::string_view nameless) {
    std::vector<std::string> names;
    for (const auto& thing : things) {
        names.push_back(thing.name.empty() ? std::string(nameless) : thing.name);
    }
    std::map<std::string, int> uses;
    for (const auto& name : names) ++uses[name];
    for (std::size_t i = 0; i < names.size(); ++i) {
        const int line = things[i].location.line;
        if (uses[names[i]] > 1 && line > 0) names[i] += fmt::format("@{}", line);
    }

    uses.clear();
    for (const auto& name : names) ++uses[name];
    std::map<std::string, int> used;
    for (auto& name : names) {
        if (uses[name] == 1) continue;
        const int number = ++used[name];
        name += fmt::format("#{}", number);
    }
    return names;
}

}  // namespace

Names::Names(const scene::Scene& scene)
    : scene_(scene), solids_(distinct_names(scene.solids, "solid")) {
    // An object that is a solid of its own goes by the solid's name.
    objects_ = distinct_names(scene.objects, "object");
    std::vector<int> count(scene.solids.size(), 0);
    for (const auto& object : scene.objects) ++count[object.solid];
    for (std::size_t i = 0; i < objects_.size(); ++i) {
        const std::size_t solid = scene.objects[i].solid;
        objects_[i] = count[solid] == 1 ? solids_[solid]
                                        : fmt::format("{} of {}", objects_[i], solids_[solid]);
    }
}

const std::string& Names::solid(int solid) const {
    static const std::string outside = "the outside";
    return solid == tracer::outside ? outside : solids_[std::size_t(solid)];
}

std::string Names::with_priority(int solid) const {
    if (solid == tracer::outside) return this->solid(solid);
    return fmt::format("{} (priority {})", this->solid(solid),
                       text(scene_.solids[std::size_t(solid)].interior.priority));
}

std::string place(const scene::Location& location) {
    if (location.line <= 0) return location.file;
    return fmt::format("{}:{}", location.file, location.line);
}

std::string text(double number) {
    return fmt::format("{:.7g}", number + 0.0);  // + 0.0: no minus sign on zero
}

std::string text(const geom::Vec3& v) {
    return fmt::format("<{}, {}, {}>", text(v.x), text(v.y), text(v.z));
}

std::string text_of_color(const scene::Rgb& color) {
    return color.r == color.g && color.g == color.b ? text(color.r) : text(color);
}

}  // namespace meniscus::inspect
