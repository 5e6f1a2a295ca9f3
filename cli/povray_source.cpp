#include "cli/povray_source.hpp"

namespace meniscus::cli {

povray::RunOptions run_options(const SceneOptions& options) {
    povray::RunOptions run{
        .width = options.width, .height = options.height, .declares = {}, .library_paths = {}};
    for (const auto& declaration : options.declarations) {
        const auto equals = declaration.find('=');
        run.declares.emplace_back(declaration.substr(0, equals), declaration.substr(equals + 1));
    }
    for (const auto& path : options.library_paths) run.library_paths.emplace_back(path);
    return run;
}

}  // namespace meniscus::cli
