#include "lang/library.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "lang/diagnostic.hpp"
#include "lang/parse.hpp"

namespace meniscus::lang {
namespace {

namespace fs = std::filesystem;

const std::vector<fs::path>& usual_folders() {
    static const std::vector<fs::path> folders{
        "/usr/share/povray-3.7/include", "/usr/local/share/povray-3.7/include",
        "/usr/share/povray/include", "/usr/local/share/povray/include",
        "/opt/homebrew/share/povray-3.7/include"};
    return folders;
}

bool is_file(const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

std::optional<fs::path> find_in_other_case(const fs::path& folder, const fs::path& name) {
    std::error_code error;
    const auto wanted = lower(name.filename().string());
    for (fs::directory_iterator entry(folder / name.parent_path(), error), end;
         !error && entry != end; entry.increment(error)) {
        if (lower(entry->path().filename().string()) == wanted && is_file(entry->path()))
            return entry->path();
    }
    return std::nullopt;
}

std::string read_file(const fs::path& path, std::size_t most_bytes, const Span& asked) {
    const auto fail = [&](const std::string& why) -> FileError {
        if (asked.source) return {asked, fmt::format("cannot read '{}': {}", path.string(), why)};
        return FileError(Diagnostic{Diagnostic::Severity::error,
                                    {path.string(), 0, 0},
                                    fmt::format("cannot read the file: {}", why),
                                    {},
                                    0});
    };
    std::error_code error;
    if (fs::is_directory(path, error)) throw fail("it is a folder");
    std::ifstream in(path, std::ios::binary);
    if (!in) throw fail(std::strerror(errno));
    std::string text;
    std::vector<char> chunk(std::size_t{1} << 16);
    while (in.read(chunk.data(), static_cast<std::streamsize>(chunk.size())) || in.gcount() > 0) {
        text.append(chunk.data(), static_cast<std::size_t>(in.gcount()));
        if (text.size() > most_bytes)
            throw fail(fmt::format("it is larger than {} bytes", most_bytes));
    }
    if (in.bad()) throw fail("reading failed");
    return text;
}

}  // namespace

std::optional<Library::Found> Library::find(const std::string& name, const fs::path& asking) {
    auto found = look_for(name, asking);
    if (found) found_.insert(found->path);
    return found;
}

std::optional<Library::Found> Library::look_for(const std::string& name,
                                                const fs::path& asking) const {
    const fs::path wanted(name);
    if (name.empty()) return std::nullopt;
    if (wanted.is_absolute())
        return is_file(wanted) ? std::optional<Found>{{wanted, false}} : std::nullopt;

    std::vector<fs::path> folders{asking, scene_folder_};
    folders.insert(folders.end(), options_.library_paths.begin(), options_.library_paths.end());
    folders.insert(folders.end(), usual_folders().begin(), usual_folders().end());
    for (const auto& folder : folders) {
        if (is_file(folder / wanted)) return Found{folder / wanted, false};
    }
    for (const auto& folder : folders) {
        if (const auto other = find_in_other_case(folder.empty() ? "." : folder, wanted))
            return Found{*other, true};
    }
    return std::nullopt;
}

const ParsedFile& Library::load(const fs::path& path, const Span& asked) {
    if (const auto known = by_path_.find(path); known != by_path_.end()) return *known->second;
    auto text = read_file(path, options_.limits.file_bytes, asked);
    const auto& file =
        parse_source(std::make_unique<Source>(path.string(), std::move(text), path.parent_path()));
    by_path_.emplace(path, &file);
    found_.insert(path);
    return file;
}

const ParsedFile& Library::add(std::string name, std::string text) {
    return parse_source(std::make_unique<Source>(std::move(name), std::move(text)));
}

const ParsedFile& Library::parse_source(std::unique_ptr<Source> source) {
    files_.push_back(std::make_unique<ParsedFile>(ParsedFile{std::move(source), {}}));
    auto& file = *files_.back();
    file.program = parse(*file.source);
    return file;
}

const ast::Program& Library::body(const Span& span) {
    auto& body = bodies_[{span.source, span.begin}];
    if (!body) body = std::make_unique<ast::Program>(parse(span));
    return *body;
}

}  // namespace meniscus::lang
