#include "lang/interpret.hpp"

#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <utility>

#include "grammar/words.hpp"
#include "lang/cursor.hpp"
#include "lang/read_scene.hpp"
#include "lang/session.hpp"
#include "lang/stack.hpp"

namespace meniscus::lang {
namespace {

/// NAME=VALUE of the command line: a number if it reads as one, else a text.
Value to_value(const std::string& text) {
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    if (!text.empty() && end && *end == '\0') return {number};
    return {text};
}

void declare_options(Session& session) {
    for (const auto& [name, value] : session.options.declares) {
        if (grammar::is_reserved(name)) {
            throw SourceError(
                Diagnostic{Diagnostic::Severity::error,
                           {},
                           "'" + name + "' is a word of the language and cannot be declared",
                           {},
                           0});
        }
        *session.symbols.declare(name) = to_value(value);
    }
}

template <class Load>
Interpreted interpret_here(const Options& options, Load load) {
    Session session(options);
    std::vector<UnusedObject> unused_objects;
    try {
        declare_options(session);
        const ParsedFile& file = load(session);
        Cursor cursor(session, file.program.items, file.program.end, "scene");
        read_scene(cursor);
        unused_objects = session.object_use.unused(*file.source);
    } catch (const std::invalid_argument& error) {  // geometry whose numbers run out
        throw SourceError(Diagnostic{Diagnostic::Severity::error, {}, error.what(), {}, 0});
    } catch (SourceError& error) {
        for (auto& note : session.notes()) error.add_note(std::move(note));
        throw;
    }
    // below 3.7, POV-Ray corrects nothing unless the scene says how its numbers are meant
    session.scene.settings.raw_output =
        !session.states_gamma && session.version.value_or(3.6) < 3.7;
    return {std::move(session.scene),
            session.warnings(),
            std::move(session.messages),
            std::move(unused_objects),
            {session.library.files().begin(), session.library.files().end()}};
}

template <class Load>
Interpreted interpret(const Options& options, Load load) {
    std::optional<Interpreted> result;
    run_on_own_stack([&] { result = interpret_here(options, load); });
    return std::move(*result);
}

}  // namespace

Interpreted interpret_file(const std::filesystem::path& path, const Options& options) {
    return interpret(options, [&](Session& session) -> const ParsedFile& {
        session.library.set_scene_folder(path.parent_path());
        return session.library.load(path, {});
    });
}

Interpreted interpret_text(std::string name, std::string text, const Options& options) {
    return interpret(options, [&](Session& session) -> const ParsedFile& {
        return session.library.add(std::move(name), std::move(text));
    });
}

}  // namespace meniscus::lang
