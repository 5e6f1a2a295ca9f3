#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lang/diagnostic.hpp"
#include "lang/items.hpp"
#include "lang/library.hpp"
#include "lang/options.hpp"
#include "lang/symbols.hpp"
#include "lang/unused_objects.hpp"
#include "scene/scene.hpp"

namespace meniscus::lang {

/// All that changes while a scene file is carried out.
class Session {
public:
    explicit Session(const Options& given);

    const Options& options;
    Library library;
    Symbols symbols;
    ObjectUse object_use;
    TextureItem default_texture;
    std::optional<double> version;  // of #version
    bool states_gamma = false;
    std::optional<scene::WorkingSpace> srgb_taken_as;  // of the colours in `srgb` so far
    scene::Scene scene;
    std::map<std::filesystem::path, geom::Mesh> meshes;  // from files, loaded so far
    std::string messages;

    void warn(const Span& span, std::string text);
    const std::vector<Diagnostic>& warnings() const { return warnings_; }

    /// Counts one turn of a loop or one call of a macro.
    void count_step(const Span& span);

    // The macros and includes under way, outermost first. What is entered is not left on an error,
    // so that the error's notes can tell how it came about.
    void enter_macro(std::string_view name, const Span& call);
    void enter_file(const Source& source, const Span& asked);
    void leave();
    std::vector<Diagnostic> notes() const;

    /// The folder that names of files in the text are relative to.
    static std::filesystem::path folder_of(const Span& span);

private:
    struct Step {
        std::string what;
        Span span;
        const Source* file;  // null for a macro
    };
    std::vector<Step> steps_;
    int macros_ = 0, files_ = 0;
    std::size_t steps_taken_ = 0;
    std::vector<Diagnostic> warnings_;
};

}  // namespace meniscus::lang
