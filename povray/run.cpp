#include "povray/run.hpp"

#include <fmt/format.h>

#include "image/file.hpp"
#include "povray/console.hpp"
#include "povray/ppm.hpp"
#include "povray/process.hpp"
#include "povray/scratch.hpp"

namespace meniscus::povray {
namespace {

/// POV-Ray takes its own command line apart at blanks, unless they stand in quotes.
std::string quoted(const std::filesystem::path& path) {
    const auto text = std::filesystem::absolute(path).string();
    const char mark = text.find('"') == text.npos ? '"' : '\'';
    return mark + text + mark;
}

std::vector<std::string> command_line(const std::filesystem::path& scene,
                                      const RunOptions& options) {
    // The picture goes to standard output, which no "permitted paths" of its configuration forbid.
    std::vector<std::string> words = {"povray",
                                      "+I" + quoted(scene),
                                      "+O-",
                                      "+FP16",
                                      "File_Gamma=1.0",
                                      fmt::format("+W{}", options.width),
                                      fmt::format("+H{}", options.height),
                                      "-D",
                                      fmt::format("Work_Threads={}", options.threads)};
    words.insert(words.end(), options.antialiasing.begin(), options.antialiasing.end());
    for (const auto& path : options.library_paths) words.push_back("+L" + quoted(path));
    for (const auto& [name, value] : options.declares)
        words.push_back(fmt::format("Declare={}={}", name, value));
    return words;
}

}  // namespace

NotInstalled::NotInstalled()
    : std::runtime_error(
          "POV-Ray is not installed: there is no `povray` in the search path; Debian's package is "
          "povray (apt-get install povray povray-includes)") {}

Run run(const std::filesystem::path& scene, const RunOptions& options) {
    const auto file = std::filesystem::absolute(scene);
    if (!std::filesystem::exists(file)) throw image::FileError(scene, "there is no such file");
    const Scratch scratch;
    const auto picture = scratch / "picture.ppm", log = scratch / "log.txt";
    Run result;
    result.command = command_line(file, options);
    const auto status = run_process(
        result.command, {.folder = file.parent_path(), .output = picture, .errors = log});
    if (!status) throw NotInstalled();
    const Console console(image::read_file(log));
    if (*status != 0) {
        throw RunFailed(
            fmt::format("POV-Ray does not render {}:\n{}", scene.string(), console.error()));
    }
    result.picture = read_ppm(image::read_file(picture));
    result.seconds = console.seconds();
    result.cpu_seconds = console.cpu_seconds();
    result.warnings = console.warnings();
    return result;
}

Run run_text(std::string_view scene, const RunOptions& options) {
    const Scratch scratch;
    image::write_file(scratch / "scene.pov", scene);
    return run(scratch / "scene.pov", options);
}

}  // namespace meniscus::povray
