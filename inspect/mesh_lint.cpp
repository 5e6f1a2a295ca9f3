#include "inspect/mesh_lint.hpp"

#include <fmt/format.h>

namespace meniscus::inspect {

Finding about(const tracer::RenderScene& scene, const tracer::Part& part, std::string_view lint,
              Finding::Severity severity) {
    Finding finding;
    finding.severity = severity;
    finding.lint = lint;
    finding.location = scene.source.objects[std::size_t(part.object)].location;
    return finding;
}

std::string counted(std::size_t count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace meniscus::inspect
