#include "tracer/contrast.hpp"

namespace meniscus::tracer {
namespace {

double contrast(const Pixel& one, const Pixel& other) {
    const auto encoded = [](const Pixel& pixel) {
        return glm::pow(glm::clamp(pixel.mean(), 0.0, 1.0), scene::Rgb{1.0 / 2.5});
    };
    const scene::Rgb d = glm::abs(encoded(one) - encoded(other));
    return d.r + d.g + d.b;
}

}  // namespace

std::vector<bool> contrasting_pixels(const Film& film, double threshold) {
    const Region region = film.region();
    std::vector<bool> marked(std::size_t(film.width()) * std::size_t(film.height()), false);
    for (int y = region.y0; y < region.y1; ++y) {
        for (int x = region.x0; x < region.x1; ++x) {
            const Pixel pixel = film.at(x, y);
            const bool left = x > region.x0 && contrast(pixel, film.at(x - 1, y)) >= threshold;
            const bool above = y > region.y0 && contrast(pixel, film.at(x, y - 1)) >= threshold;
            if (left || above || threshold <= 0.0) marked[film.index(x, y)] = true;
            if (left) marked[film.index(x - 1, y)] = true;
            if (above) marked[film.index(x, y - 1)] = true;
        }
    }
    return marked;
}

}  // namespace meniscus::tracer
