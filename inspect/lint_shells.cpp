#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "inspect/lints.hpp"
#include "inspect/meeting.hpp"
#include "inspect/mesh_lint.hpp"
#include "inspect/sample_lines.hpp"
#include "inspect/self_intersection.hpp"

namespace meniscus::inspect {
namespace {

using tracer::Part;
using tracer::RenderScene;

/// What triangles of one mesh do to each other: once for each mesh.
class ShellLint {
public:
    ShellLint(const RenderScene& scene, const Names& names, const Part& part,
              const geom::TriangleMesh& mesh, std::vector<Finding>& findings)
        : scene_(scene),
          name_(names.object(part.object)),
          part_(part),
          mesh_(mesh),
          findings_(findings) {}

    void run() {
        const SelfIntersections found = self_intersections(mesh_);
        if (found.cuts) {
            add(*found.cuts, "self-intersecting-mesh", Finding::Severity::warning,
                "{} cuts through itself: {}, as at {} by {}, where {} meets {}",
                "mend the mesh; inside and outside are counted, so that a fold that is turned "
                "inside out is a hole");
        }
        if (found.overlaps) {
            add(*found.overlaps, "overlapping-triangles", Finding::Severity::warning,
                "{} covers itself: {} that lie on each other and look the same way, as at {}, {} "
                "wide, where {} lies on {}",
                "leave one of the two sheets out; what is twice inside is not left when one is");
        }
        if (found.pierced) {
            add(*found.pierced, "pierced-cavity", Finding::Severity::warning,
                "a cavity of {} sticks through another of its shells: {}, as at {} by {}, where {} "
                "meets {}",
                "keep cavities inside of what they hollow out; or make the cavity a solid of its "
                "own: material { ior 1 } with a higher priority");
        }
        if (found.folds && !found.cuts && !found.overlaps) {
            add(*found.folds, "folded-mesh", Finding::Severity::note,
                "{} touches itself: {} that lie on each other back to back, as at {}, {} wide, "
                "where {} lies on {}",
                "nothing need be done: nothing is between them");
        }
        if (found.repeated) {
            add(*found.repeated, "repeated-triangles", Finding::Severity::note,
                "{} has triangles twice: {} with the same corners, that look the same way, as at "
                "{}, {} wide: {} and {}; they count as one solid",
                "leave one of each out; the picture is the same without, and sooner made");
        }
        if (found.unions) {
            add(*found.unions, "nested-shells", Finding::Severity::note,
                "{} has shells that overlap: {}, as at {} by {}, where {} meets {}; they count as "
                "one solid",
                "nothing need be done if that is meant; it is a union");
        } else if (mesh_.stats().components > 1) {
            find_shell_in_shell();
        }
        find_gaps();
    }

private:
    void add(const TrianglePairs& pairs, std::string_view lint, Finding::Severity severity,
             std::string_view format, std::string advice) {
        Finding finding = about(scene_, part_, lint, severity);
        const auto& map = part_.shape.transform();
        finding.position = map.point(pairs.position);
        finding.depth = pairs.depth * map.largest_scale();
        const std::string count = counted(pairs.count, "pair") + " of triangles";
        const std::string position = text(*finding.position), depth = text(*finding.depth);
        const std::string first = triangle(pairs.first), second = triangle(pairs.second);
        finding.text =
            fmt::format(fmt::runtime(format), name_, count, position, depth, first, second);
        finding.advice = std::move(advice);
        for (const geom::Face face : {pairs.first, pairs.second}) {
            if (const auto number = mesh_.number(face)) finding.triangles.push_back(*number);
        }
        findings_.push_back(std::move(finding));
    }

    /// "triangle 7 <0, 0, 0> <1, 0, 0> <0, 1, 0>"
    std::string triangle(geom::Face face) const {
        const auto number = mesh_.number(face);
        std::string result = number ? fmt::format("triangle {}", *number) : "the triangle";
        for (const auto& corner : mesh_.corners(face))
            result += ' ' + text(part_.shape.transform().point(corner));
        return result;
    }

    void find_shell_in_shell() {
        geom::Crossings crossings;
        for (const geom::Ray& line : sample_lines(mesh_.bounds(), lines_per_axis)) {
            crossings.clear();
            mesh_.crossings(line, crossings);
            int depth = 0;
            for (const auto& crossing : crossings) {
                depth += crossing.entering ? 1 : -1;
                if (depth < 2) continue;
                Finding finding = about(scene_, part_, "nested-shells", Finding::Severity::note);
                finding.position = part_.shape.transform().point(line.at(crossing.t));
                finding.text = fmt::format(
                    "{} has a shell within a shell, as at {}: they count as one solid, not as a "
                    "cavity",
                    name_, text(*finding.position));
                finding.advice =
                    "for a cavity, wind the inner shell the other way or make it a solid of its "
                    "own: material { ior 1 } with a higher priority";
                findings_.push_back(std::move(finding));
                return;
            }
        }
    }

    /// Slits between shells, or within a shell that comes back to itself.
    void find_gaps() {
        std::vector<Gap> gaps;
        for (const geom::Ray& line : sample_lines(part_.shape.bounds(), lines_per_axis)) {
            const auto stretches = inside(part_, line);
            for (std::size_t i = 1; i < stretches.size(); ++i)
                add_gap(line, stretches[i - 1], stretches[i], gaps);
        }
        if (gaps.size() < fewest_slits) return;
        const auto widest = std::ranges::max_element(gaps, {}, &Gap::width);
        Finding finding = about(scene_, part_, "thin-gap");
        finding.position = widest->position;
        finding.depth = widest->width;
        finding.text = fmt::format(
            "between surfaces of {} there is a gap of {}, as at {}: light is reflected on both its "
            "sides as on any film",
            name_, text(widest->width), text(widest->position));
        finding.advice = fmt::format(
            "let the surfaces meet or overlap; or state `global_settings {{ contact_tolerance "
            "{:.1g} }}`",
            4.0 * widest->width);
        findings_.push_back(std::move(finding));
    }

    /// From where the line leaves the mesh to where it enters it anew.
    void add_gap(const geom::Ray& line, const Inside& left, const Inside& entered,
                 std::vector<Gap>& gaps) const {
        const double length = entered.begin - left.end;
        const geom::Vec3 p = line.at(left.end);
        const double width =
            length * std::abs(glm::dot(part_.shape.normal(left.last, p), line.direction));
        if (is_thin(scene_, width, geom::max_abs(p) + part_.shape.magnitude()))
            gaps.push_back({width, line.at(left.end + 0.5 * length)});
    }

    static constexpr int lines_per_axis = 256;

    const RenderScene& scene_;
    std::string name_;
    const Part& part_;
    const geom::TriangleMesh& mesh_;
    std::vector<Finding>& findings_;
};

}  // namespace

void find_bad_shells(const RenderScene& scene, const Names& names, std::vector<Finding>& findings) {
    visit_meshes(scene, [&](const Part& part, const geom::TriangleMesh& mesh) {
        if (part.is_member) ShellLint(scene, names, part, mesh, findings).run();
    });
}

}  // namespace meniscus::inspect
