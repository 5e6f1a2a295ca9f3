// Not a test: how near our pictures are to POV-Ray's, a line for each scene with tabs between its
// fields.
//     povray_compare [--size 160x120] [--keep FOLDER] FILE...        any scene files
//     povray_compare [...] --random FIRST LAST                       random scenes; those that
//     differ are kept
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

#include "lang/interpret.hpp"
#include "povray/run.hpp"
#include "tests/povray/difference.hpp"
#include "tests/povray/random_pov.hpp"
#include "tracer/render.hpp"

using namespace meniscus;

namespace {

int width = 160, height = 120;
std::filesystem::path keep;

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

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::filesystem::path> files;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--size" && i + 1 < argc) {
            if (std::sscanf(argv[++i], "%dx%d", &width, &height) != 2) return 2;
        } else if (word == "--keep" && i + 1 < argc) {
            keep = argv[++i];
            std::filesystem::create_directories(keep);
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
