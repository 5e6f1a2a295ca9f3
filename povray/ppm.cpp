#include "povray/ppm.hpp"

#include <sstream>
#include <stdexcept>

namespace meniscus::povray {
namespace {

/// A number of the head; comments may stand before it.
int read_number(std::istream& stream) {
    while ((stream >> std::ws).peek() == '#') {
        std::string comment;
        std::getline(stream, comment);
    }
    int value = 0;
    stream >> value;
    return value;
}

}  // namespace

image::Image read_ppm(const std::string& bytes) {
    std::istringstream stream(bytes);
    std::string magic;
    stream >> magic;
    const int width = read_number(stream), height = read_number(stream);
    const int maximum = read_number(stream);
    stream.get();
    if (!stream || magic != "P6" || maximum != 65535 || width < 1 || height < 1)
        throw std::runtime_error("not a 16-bit PPM picture");
    image::Image image(width, height);
    for (float& value : image.rgb) {
        const int high = stream.get(), low = stream.get();
        value = float((high * 256 + low) / 65535.0);
    }
    if (!stream) throw std::runtime_error("a PPM picture ends too early");
    return image;
}

}  // namespace meniscus::povray
