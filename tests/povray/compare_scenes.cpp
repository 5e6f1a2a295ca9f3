// Not a test: how near our pictures are to POV-Ray's, a line for each scene with tabs between its
// fields.
//     povray_compare [--size 160x120] [--keep FOLDER] [--general] FILE...        any scene files
//     povray_compare [...] --random FIRST LAST                       random scenes; those that
//     differ are kept
//     povray_compare [...] --golden FOLDER [PICTURES]                the golden scenes of a folder,
//     by each of their models: "within" or "above" what they expect. POV-Ray's pictures are kept in
//     PICTURES, and taken from there if they are there.
// Fields: file, "ok" (both rendered it), "unread" (we cannot), "povray" (POV-Ray cannot) or
// "failed", then figures or words.

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "image/file.hpp"
#include "lang/interpret.hpp"
#include "povray/ppm.hpp"
#include "povray/run.hpp"
#include "tests/povray/difference.hpp"
#include "tests/povray/golden.hpp"
#include "tests/povray/random_pov.hpp"
#include "tracer/render.hpp"

using namespace meniscus;

namespace {

int width = 160, height = 120;
std::filesystem::path keep;
tracer::Kernel kernel = tracer::Kernel::automatic;

/// As a PPM of 8 bits, encoded for a display.
template <class Values>
void save(const Values& values, const std::filesystem::path& file) {
    std::ofstream out(file, std::ios::binary);
    out << "P6\n" << width << ' ' << height << "\n255\n";
    for (const double linear : values) {
        const double value = std::fmin(std::fmax(linear, 0.0), 1.0);
        const double encoded =
            value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055;
        out.put(char(int(encoded * 255.0 + 0.5)));
    }
}

std::string one_line(std::string text) {
    for (char& c : text) {
        if (c == '\n' || c == '\t') c = ' ';
    }
    return text;
}

std::string verdict(const std::filesystem::path& file) {
    tracer::Rendered ours;
    try {
        lang::Options reading;
        reading.image_width = width;
        reading.image_height = height;
        tracer::Options options;
        options.width = width;
        options.height = height;
        options.sampling = tracer::GridSampling{1};
        options.threads = 1;
        ours = tracer::render(tracer::compile(lang::interpret_file(file, reading).scene), options);
    } catch (const lang::SourceError& error) {
        return "unread\t" + one_line(lang::format(error));
    } catch (const std::exception& error) {
        return std::string("failed\t") + one_line(error.what());
    }
    try {
        const auto theirs = povray::run(file, {.width = width, .height = height}).picture;
        const auto d = test::difference(theirs, ours.picture);
        if (!keep.empty()) {
            save(ours.picture.rgb, keep / (file.stem().string() + ".meniscus.ppm"));
            save(theirs.rgb, keep / (file.stem().string() + ".povray.ppm"));
        }
        return fmt::format("ok\trmse {:.3g}\toff {:.4f}\tlargest {:.3g}\tat {},{}\tleaks {}",
                           d.rmse, d.share_off, d.largest, d.worst_x, d.worst_y,
                           ours.statistics.leaks);
    } catch (const std::exception& error) {
        return "povray\t" + one_line(error.what());
    }
}

/// POV-Ray's picture of an export, or the one kept of it.
image::Image theirs(const std::filesystem::path& kept, const std::string& scene) {
    if (!kept.empty() && std::filesystem::exists(kept))
        return povray::read_ppm(image::read_file(kept));
    const auto picture = povray::run_text(scene, {.width = width, .height = height}).picture;
    if (kept.empty()) return picture;
    auto bytes = fmt::format("P6\n{} {}\n65535\n", picture.width, picture.height);
    for (const float value : picture.rgb) {
        const auto step = std::lround(65535.0 * double(value));
        bytes += {char(step / 256), char(step % 256)};
    }
    image::write_file(kept, bytes);
    return picture;
}

void compare_golden(const std::filesystem::path& folder, const std::filesystem::path& pictures) {
    if (!pictures.empty()) std::filesystem::create_directories(pictures);
    for (const auto& path : test::golden_scenes(folder)) {
        const auto scene = test::read_golden(path, width, height);
        for (const auto& expected : test::expectations(path)) {
            const auto name = fmt::format("{}-{}.ppm", path.stem().string(), int(expected.model));
            const auto reference = theirs(pictures.empty() ? pictures : pictures / name,
                                          test::export_golden(scene, expected).text);
            const auto ours = test::render_golden(scene, expected, width, height, kernel);
            const auto d = test::difference_off_edges(reference, ours.picture);
            const bool good = d.rmse <= expected.rmse &&
                              100.0 * d.share_off <= expected.percent_off &&
                              ours.statistics.leaks == 0;
            fmt::print("{}\t{}\t{}\trmse {:.3g} of {:g}\toff {:.3f} % of {:g} %\tleaks {}\n",
                       path.stem().string(), expected.text, good ? "within" : "above", d.rmse,
                       expected.rmse, 100.0 * d.share_off, expected.percent_off,
                       ours.statistics.leaks);
            std::fflush(stdout);
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::filesystem::path> files;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--size" && i + 1 < argc) {
            if (std::sscanf(argv[++i], "%dx%d", &width, &height) != 2) return 2;
        } else if (word == "--general") {
            kernel = tracer::Kernel::general;
        } else if (word == "--keep" && i + 1 < argc) {
            keep = argv[++i];
            std::filesystem::create_directories(keep);
        } else if (word == "--golden" && i + 1 < argc) {
            const std::filesystem::path folder = argv[++i];
            compare_golden(folder, i + 1 < argc ? argv[++i] : "");
        } else if (word == "--random" && i + 2 < argc) {
            const auto first = std::strtoull(argv[i + 1], nullptr, 10),
                       last = std::strtoull(argv[i + 2], nullptr, 10);
            i += 2;
            const auto folder = keep.empty() ? std::filesystem::current_path() : keep;
            for (auto seed = first; seed <= last; ++seed) {
                const auto file = folder / fmt::format("random-{}.pov", seed);
                std::ofstream(file) << test::random_pov(seed);
                const std::string seen = verdict(file);
                double rmse = 1.0;
                std::sscanf(seen.c_str(), "ok\trmse %lf", &rmse);
                fmt::print("{}\t{}\n", seed, seen);
                std::fflush(stdout);
                if (rmse < 1e-3) std::filesystem::remove(file);
            }
        } else {
            files.emplace_back(word);
        }
    }
    for (const auto& file : files) {
        fmt::print("{}\t{}\n", file.string(), verdict(std::filesystem::absolute(file)));
        std::fflush(stdout);
    }
}
