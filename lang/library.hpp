#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "lang/ast.hpp"
#include "lang/options.hpp"
#include "lang/source.hpp"

namespace meniscus::lang {

/// One file and what it says.
struct ParsedFile {
    std::unique_ptr<Source> source;
    ast::Program program;
};

/// Finds, reads and parses files, each once, and keeps them for as long as anything read from them
/// lives.
class Library {
public:
    explicit Library(const Options& options) : options_(options) {}

    struct Found {
        std::filesystem::path path;
        bool other_case = false;  // found by ignoring upper and lower case
    };
    /// Looks beside the file that asks, beside the scene, in the library paths and where POV-Ray
    /// keeps its includes.
    std::optional<Found> find(const std::string& name, const std::filesystem::path& asking);
    void set_scene_folder(std::filesystem::path folder) { scene_folder_ = std::move(folder); }

    /// Reads a file; `asked` is where the scene names it. Throws FileError or SourceError.
    const ParsedFile& load(const std::filesystem::path& path, const Span& asked);
    const ParsedFile& add(std::string name, std::string text);

    /// A macro's body, parsed when first asked for.
    const ast::Program& body(const Span& span);

    /// All files that were found so far, of any kind.
    const std::set<std::filesystem::path>& files() const { return found_; }

private:
    std::optional<Found> look_for(const std::string& name,
                                  const std::filesystem::path& asking) const;
    const ParsedFile& parse_source(std::unique_ptr<Source> source);

    const Options& options_;
    std::filesystem::path scene_folder_;
    std::set<std::filesystem::path> found_;
    std::map<std::filesystem::path, const ParsedFile*> by_path_;
    std::vector<std::unique_ptr<ParsedFile>> files_;
    std::map<std::pair<const Source*, std::uint32_t>, std::unique_ptr<ast::Program>> bodies_;
};

}  // namespace meniscus::lang
