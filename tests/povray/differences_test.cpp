// Where Meniscus differs from POV-Ray on purpose: each scene in differences/ and the tables of
// docs/povray-differences.md, against what is expected of both renderers by a formula.

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <regex>
#include <sstream>

#include "image/file.hpp"
#include "lang/diagnostic.hpp"
#include "lang/interpret.hpp"
#include "povray/run.hpp"
#include "tests/povray/golden.hpp"

using namespace meniscus;

namespace {

constexpr int width = 81, height = 61;
// Half a step of 16 bits in a picture, half a step of the page's five decimals.
constexpr double rounding = 0.5 / 65535 + 0.5e-5;

/// What a scene's pixel must be. In [least, greatest] where chance decides.
struct Range {
    double least, greatest;
    explicit(false) Range(double value, double margin = 0.0)
        : least(value - margin), greatest(value + margin) {}
    bool is_point() const { return least == greatest; }
    bool holds(double value) const {
        return value >= least - rounding && value <= greatest + rounding;
    }
};

/// Of normal incidence.
double reflectance(double from, double to) { return std::pow((from - to) / (from + to), 2.0); }

/// What parallel faces, each between two media, let through, with all reflections between them.
double through(const std::vector<std::pair<double, double>>& faces) {
    double sum = 0.0;
    for (const auto& [from, to] : faces) {
        const double r = reflectance(from, to);
        sum += r / (1.0 - r);
    }
    return 1.0 / (1.0 + sum);
}

/// union.pov: where on the wall the pixel's ray ends that runs `air` in air and `glass` in glass.
double ramp_behind_slab(double air, double glass) {
    const double steepness = (2.0 * 60.5 / width - 1.0) * std::tan(std::numbers::pi / 12.0);
    const double inside = std::asin(std::sin(std::atan(steepness)) / 2.0);
    return (air * steepness + glass * std::tan(inside) + 4.0) / 8.0;
}

/// torus.pov, in the plane of the ring's circle: where on the wall the pixel's ray ends that
/// crosses these circles about the axis in turn, each time into another index.
double ramp_behind_circles(const std::vector<std::array<double, 2>>& radii_and_iors) {
    double x = (60.5 / width - 0.5) * 4.0 / 3.0, z = -5.0, dx = 0.0, dz = 1.0, ior = 1.0;
    for (const auto& [radius, next] : radii_and_iors) {
        const double along = x * dx + z * dz, within = x * x + z * z - radius * radius;
        const double root = std::sqrt(along * along - within);
        const bool is_outside = within > 1e-9;
        const double way = is_outside ? -along - root : -along + root;
        x += way * dx, z += way * dz;
        // The normal against the ray; Snell's law for the part across it.
        const double sign = is_outside ? 1.0 : -1.0;
        const double nx = sign * x / radius, nz = sign * z / radius;
        const double cosine = -(dx * nx + dz * nz), ratio = ior / next;
        const double across = std::sqrt(1.0 - ratio * ratio * (1.0 - cosine * cosine));
        dx = ratio * dx + (ratio * cosine - across) * nx;
        dz = ratio * dz + (ratio * cosine - across) * nz;
        ior = next;
    }
    return (x + (4.0 - z) * dx / dz + 4.0) / 8.0;
}

/// hair.scene: beside the slab the sky is 1; in front of it, what two faces reflect and let
/// through.
double slab_before_sky() {
    const double r = reflectance(1.0, 1.5), absorbed = std::exp(-5.0 * 2.0);
    return r + (1.0 - r) * (1.0 - r) * absorbed;
}

const double ball_focus = 1.3 * 0.9 / (2.0 * 0.3);  // photons.pov: of light near the axis

struct Rendered {
    Range theirs, ours;
};
const std::map<std::string, Rendered> rendered = {
    // Four lamps of a quarter; the screen hides the upper two of them, and not their middle.
    {"area_light.pov", {0.5, 1.0}},
    {"crand.pov", {{0.75, 0.25}, {0.75, 0.25}}},
    {"fade.pov", {1.0, std::exp(-0.25)}},
    {"far.pov", {0.0, 1.0}},
    // The edge is at 100000 or 100000.003, the pixel's centre between them.
    {"far_mesh.pov", {0.0, 1.0}},
    {"far_side.pov", {0.5, 0.0}},
    {"hair.scene", {slab_before_sky(), 1.0}},
    // The sine is 1/1.33000002: 1.33 lets the light out, 1.33000004 reflects it.
    {"ior_precision.pov", {0.0, 1.0}},
    // POV-Ray's formula for a film seen and lit from in front: 2 x 0.25 is its thickness twice
    // over.
    {"irid.pov", {0.5 * (1.0 + 0.5 * std::cos(std::numbers::pi / 0.7)), 0.5}},
    // The wall is 0.95 from the axis, in front and behind.
    {"lathe.pov", {{5.0 / 8.0, 1e-3}, (5.0 - 0.95) / 8.0}},
    // Nothing reflects; POV-Ray is out of levels.
    {"levels.scene", {0.0, 1.0}},
    {"near_shadow.pov", {1.0, 0.0}},
    {"nested_fresnel.pov",
     {through({{1.0, 1.5}, {1.5, 2.0}, {1.5, 1.0}}),
      through({{1.0, 1.5}, {1.5, 2.0}, {2.0, 1.5}, {1.5, 1.0}})}},
    // A thin bundle, three units behind the middle of the ball, is narrower by as much; POV-Ray
    // gathers photons from a disc, about which they are fewer.
    {"photons.pov", {{0.2 / std::pow(1.0 - 3.0 / ball_focus, 2.0), 0.05}, 0.2}},
    // Half of what a white half-space sends.
    {"radiosity.pov", {{0.5, 0.005}, 0.0}},
    {"thin_pane.pov", {through({{1.0, 1.5}}), through({{1.0, 1.5}, {1.5, 1.0}})}},
    // The sheet within is met at 1 - 0.6 from the axis, on the way in and on the way out.
    {"torus.pov",
     {ramp_behind_circles({{1.6, 1.3}, {0.4, 1.0}, {0.4, 1.3}, {1.6, 1.0}}),
      ramp_behind_circles({{1.6, 1.3}, {1.6, 1.0}})}},
    // A film of air where the slabs overlap, or a slab of glass.
    {"union.pov", {ramp_behind_slab(7.4, 1.6), ramp_behind_slab(7.0, 2.0)}},
};

struct Refused {
    Range theirs;
    std::string word;
};
const std::map<std::string, Refused> refused = {
    {"difference.pov", {0.0, "difference"}},
    {"fog.pov", {1.0 - std::exp(-5.0 / 5.0), "fog"}},
    {"intersection.pov", {1.0, "intersection"}},
    {"media.pov", {std::exp(-0.5 * 2.0), "media"}},
    {"merge.pov", {through({{1.0, 1.5}, {1.5, 1.0}}), "merge"}},
    {"noise.pov", {{0.5, 0.5}, "bozo"}},
    {"normal.pov", {{0.95, 0.045}, "normal"}},  // bumps turn the normal away from the lamp
};

std::filesystem::path scene_path(const std::string& name) {
    return std::filesystem::path(DIFFERENCES_FOLDER) / name;
}

std::pair<int, int> pixel_of(const std::string& name) {
    const auto text = image::read_file(scene_path(name));
    std::smatch match;
    REQUIRE(std::regex_search(text, match, std::regex("\n// pixel (\\d+), (\\d+)\n")));
    return {std::stoi(match[1]), std::stoi(match[2])};
}

scene::Scene read(const std::string& name) {
    lang::Options reading;
    reading.image_width = width;
    reading.image_height = height;
    return lang::interpret_file(scene_path(name), reading).scene;
}

const test::Expectation contact{povray::Model::contact, 0.0, 0.0, 0.0, "contact"};

image::Image theirs(const std::string& name) {
    const povray::RunOptions options{.width = width, .height = height};
    if (name.ends_with(".scene"))
        return povray::run_text(test::export_golden(read(name), contact).text, options).picture;
    return povray::run(scene_path(name), options).picture;
}

image::Image ours(const std::string& name) {
    return test::render_golden(read(name), contact, width, height).picture;
}

double red(const image::Image& picture, const std::string& name) {
    const auto [x, y] = pixel_of(name);
    return picture.pixel(x, y)[0];
}

/// A row of a table of the page, by the scene's name: pixel, POV-Ray's number, ours or what we say.
struct Row {
    int x, y;
    double theirs;
    std::string ours;
};
std::map<std::string, Row> rows_of_page() {
    std::map<std::string, Row> result;
    std::istringstream page(image::read_file(DIFFERENCES_PAGE));
    const std::regex pattern(
        R"(\| \[(.+)\]\(.+\) \| (\d+), (\d+) \| ([0-9.]+) \| (?:`` )?(.+?)(?: ``)? \|)");
    std::smatch match;
    for (std::string line; std::getline(page, line);) {
        if (std::regex_match(line, match, pattern))
            result[match[1]] = {std::stoi(match[2]), std::stoi(match[3]), std::stod(match[4]),
                                match[5]};
    }
    return result;
}

/// The page's row has the pixel that the scene names, and POV-Ray's number.
Row row_of(const std::string& name, const Range& their_range, double theirs) {
    const auto rows = rows_of_page();
    INFO("scripts/povray-differences writes the page anew");
    REQUIRE(rows.contains(name));
    const Row& row = rows.at(name);
    CHECK(std::pair(row.x, row.y) == pixel_of(name));
    CHECK(their_range.holds(row.theirs));
    if (their_range.is_point()) CHECK(std::abs(row.theirs - theirs) <= rounding);
    return row;
}

}  // namespace

TEST_CASE("differences on purpose are as large as the page says", "[povray][differences]") {
    for (const auto& [name, expected] : rendered) {
        DYNAMIC_SECTION(name) {
            const double of_theirs = red(theirs(name), name), of_ours = red(ours(name), name);
            CAPTURE(of_theirs, of_ours);
            CHECK(expected.theirs.holds(of_theirs));
            CHECK(expected.ours.holds(of_ours));
            const Row row = row_of(name, expected.theirs, of_theirs);
            CHECK(expected.ours.holds(std::stod(row.ours)));
            if (expected.ours.is_point())
                CHECK(std::abs(std::stod(row.ours) - of_ours) <= rounding);
        }
    }
}

TEST_CASE("differences on purpose: what is refused is so as the page says",
          "[povray][differences]") {
    for (const auto& [name, expected] : refused) {
        DYNAMIC_SECTION(name) {
            const double of_theirs = red(theirs(name), name);
            CAPTURE(of_theirs);
            CHECK(expected.theirs.holds(of_theirs));
            const Row row = row_of(name, expected.theirs, of_theirs);
            try {
                read(name);
                FAIL("an error was expected");
            } catch (const lang::SourceError& error) {
                const auto text = lang::format(error);
                const auto line = text.substr(0, text.find('\n'));
                CHECK(line.ends_with("/" + row.ours));
                CHECK(line.ends_with("not supported here: `" + expected.word + "`"));
            }
        }
    }
}

TEST_CASE("differences on purpose: every scene has its pair of numbers", "[povray][differences]") {
    std::size_t scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(DIFFERENCES_FOLDER)) {
        const auto name = entry.path().filename().string();
        CAPTURE(name);
        CHECK(rendered.contains(name) != refused.contains(name));
        ++scenes;
    }
    CHECK(scenes == rendered.size() + refused.size());
    CHECK(rows_of_page().size() == scenes);
}

// crand takes a number in [0, 0.5) off each pixel: 4941 of them have a mean of 0.75 and a standard
// error of 0.5 / sqrt(12 x 4941).
TEST_CASE("differences on purpose: the grain of both has one mean", "[povray][differences]") {
    for (const auto& picture : {theirs("crand.pov"), ours("crand.pov")}) {
        double sum = 0.0;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) sum += picture.pixel(x, y)[0];
        }
        CHECK(sum / (width * height) == Approx(0.75).margin(4.0 * 0.5 / std::sqrt(12.0 * 4941)));
    }
}
