#include "tests/povray/povray.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>
#include <stdexcept>

namespace meniscus::test {
namespace {

std::string read_all(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// A folder of its own under the system's temporary one, gone with the object.
struct Scratch {
    std::filesystem::path path;
    Scratch() {
        std::string name =
            (std::filesystem::temp_directory_path() / "meniscus-povray-XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
        path = name;
    }
    ~Scratch() { std::filesystem::remove_all(path); }
};

}  // namespace

Reference run_povray(const std::filesystem::path& scene, int width, int height) {
    const Scratch scratch;
    const auto picture = scratch.path / "out.ppm", log = scratch.path / "log.txt";
    const std::string command = fmt::format(
        "cd '{}' && povray +I'{}' +O'{}' +FP16 File_Gamma=1.0 +W{} +H{} -D -A Work_Threads=1 >'{}' "
        "2>&1",
        scene.parent_path().string(), scene.string(), picture.string(), width, height,
        log.string());
    if (std::system(command.c_str()) != 0 || !std::filesystem::exists(picture)) {
        // Its own words come last, behind a page on its version and its authors.
        const std::string words = read_all(log);
        const auto error = words.find("Error");
        throw std::runtime_error(fmt::format(
            "POV-Ray 3.7 (Debian package povray) does not render {}:\n{}", scene.string(),
            error == std::string::npos ? words : words.substr(words.rfind('\n', error) + 1)));
    }
    std::istringstream file(read_all(picture));
    std::string magic;
    int maximum = 0;
    Reference result;
    file >> magic;
    // Comments may stand between the numbers of the head.
    const auto number = [&] {
        while ((file >> std::ws).peek() == '#') {
            std::string comment;
            std::getline(file, comment);
        }
        int value = 0;
        file >> value;
        return value;
    };
    result.width = number();
    result.height = number();
    maximum = number();
    file.get();
    if (magic != "P6" || maximum != 65535) throw std::runtime_error("not a 16-bit PPM");
    result.rgb.resize(std::size_t(3) * result.width * result.height);
    for (double& value : result.rgb) {
        const int high = file.get(), low = file.get();
        value = (high * 256 + low) / 65535.0;
    }
    return result;
}

std::string Difference::text() const {
    return fmt::format(
        "rmse {:.2e}, largest {:.2e} at ({}, {}), {:.2f} % of pixels off by more than 0.02", rmse,
        largest, worst_x, worst_y, 100.0 * share_off);
}

Difference difference(const Reference& reference, const std::vector<float>& rgb,
                      std::size_t outliers) {
    if (reference.rgb.size() != rgb.size()) throw std::runtime_error("pictures of different size");
    struct Pixel {
        double squares = 0.0, worst = 0.0;
        std::size_t index = 0;
    };
    std::vector<Pixel> pixels(rgb.size() / 3);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        pixels[i].index = i;
        for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
            const double d = std::abs(std::clamp(double(rgb[c]), 0.0, 1.0) - reference.rgb[c]);
            pixels[i].squares += d * d;
            pixels[i].worst = std::max(pixels[i].worst, d);
        }
    }
    std::ranges::sort(pixels, std::greater{}, &Pixel::worst);

    Difference result;
    double squares = 0.0;
    for (std::size_t i = outliers; i < pixels.size(); ++i) squares += pixels[i].squares;
    result.rmse = std::sqrt(squares / double(rgb.size()));
    const auto off =
        std::ranges::count_if(pixels, [](const Pixel& pixel) { return pixel.worst > 0.02; });
    result.share_off = double(off) / double(pixels.size());
    result.largest = pixels.front().worst;
    result.worst_x = int(pixels.front().index % std::size_t(reference.width));
    result.worst_y = int(pixels.front().index / std::size_t(reference.width));
    return result;
}

}  // namespace meniscus::test
