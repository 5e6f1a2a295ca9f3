#include "image/exr.hpp"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfCompression.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStdIO.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <array>
#include <sstream>
#include <vector>

namespace meniscus::image {
namespace {

constexpr int largest_side = 1 << 16;
constexpr std::array color_channels = {"R", "G", "B"};
constexpr std::size_t color_stride = 3 * sizeof(float);

Imath::Box2i display_window(const Image& image) {
    return {{0, 0}, {image.full_width - 1, image.full_height - 1}};
}

Imath::Box2i data_window(const Image& image) {
    return {{image.x0, image.y0}, {image.x0 + image.width - 1, image.y0 + image.height - 1}};
}

/// One value of each pixel; the library wants char*, also to read from.
Imf::Slice slice(const float* first, const Imath::Box2i& window, std::size_t stride) {
    auto* data = reinterpret_cast<char*>(const_cast<float*>(first));
    const std::size_t row = stride * (window.max.x - window.min.x + 1);
    return Imf::Slice::Make(Imf::FLOAT, data, window, stride, row);
}

std::vector<half> to_half(const std::vector<float>& values) {
    return {values.begin(), values.end()};
}

bool is_color(const std::string& name) { return name == "R" || name == "G" || name == "B"; }

}  // namespace

std::string encode_exr(const Image& image, const ExrOptions& options, const Metadata& metadata) {
    const auto window = data_window(image);
    Imf::Header header(display_window(image), window);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const auto& [key, value] : metadata) header.insert(key, Imf::StringAttribute(value));

    const auto halves = options.half ? to_half(image.rgb) : std::vector<half>{};
    Imf::FrameBuffer buffer;
    for (std::size_t c = 0; c < color_channels.size(); ++c) {
        const auto* name = color_channels[c];
        header.channels().insert(name, Imf::Channel(options.half ? Imf::HALF : Imf::FLOAT));
        if (options.half)
            buffer.insert(name, Imf::Slice::Make(Imf::HALF, halves.data() + c, window,
                                                 3 * sizeof(half), 3 * sizeof(half) * image.width));
        else
            buffer.insert(name, slice(image.rgb.data() + c, window, color_stride));
    }
    for (const auto& layer : image.layers) {
        header.channels().insert(layer.name, Imf::Channel(Imf::FLOAT));
        buffer.insert(layer.name, slice(layer.values.data(), window, sizeof(float)));
    }

    Imf::StdOSStream stream;
    {
        Imf::OutputFile file(stream, header, 0);
        file.setFrameBuffer(buffer);
        file.writePixels(image.height);
    }
    return stream.str();
}

Image decode_exr(std::string_view bytes) {
    Imf::Header::setMaxImageSize(largest_side, largest_side);
    Imf::StdISStream stream;
    stream.str(std::string(bytes));
    Imf::InputFile file(stream, 0);
    const auto& header = file.header();
    const auto window = header.dataWindow();
    const auto display = header.displayWindow();

    Image image(window.max.x - window.min.x + 1, window.max.y - window.min.y + 1);
    image.x0 = window.min.x - display.min.x;
    image.y0 = window.min.y - display.min.y;
    image.full_width = display.max.x - display.min.x + 1;
    image.full_height = display.max.y - display.min.y + 1;

    const auto& channels = header.channels();
    const bool is_gray = !channels.findChannel("R") && channels.findChannel("Y");
    for (auto c = channels.begin(); c != channels.end(); ++c) {
        const std::string name = c.name();
        if (!is_color(name) && !(is_gray && name == "Y"))
            image.layers.push_back({name, std::vector<float>(image.rgb.size() / 3)});
    }
    Imf::FrameBuffer buffer;
    for (std::size_t c = 0; c < color_channels.size(); ++c)
        buffer.insert(color_channels[c], slice(image.rgb.data() + c, window, color_stride));
    if (is_gray) buffer.insert("Y", slice(image.rgb.data(), window, color_stride));
    for (const auto& layer : image.layers)
        buffer.insert(layer.name, slice(layer.values.data(), window, sizeof(float)));
    file.setFrameBuffer(buffer);
    file.readPixels(window.min.y, window.max.y);
    if (is_gray)
        for (std::size_t i = 0; i < image.rgb.size(); i += 3)
            image.rgb[i + 1] = image.rgb[i + 2] = image.rgb[i];
    return image;
}

ExrHeader decode_exr_header(std::string_view bytes) {
    Imf::StdISStream stream;
    stream.str(std::string(bytes));
    const Imf::InputFile file(stream, 0);
    const auto& header = file.header();
    ExrHeader result;
    for (const char* name : {"R", "G", "B", "Y"}) {
        const auto* channel = header.channels().findChannel(name);
        result.half = result.half || (channel && channel->type == Imf::HALF);
    }
    for (auto attribute = header.begin(); attribute != header.end(); ++attribute) {
        const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute());
        if (text) result.metadata[attribute.name()] = text->value();
    }
    return result;
}

}  // namespace meniscus::image
