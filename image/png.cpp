#include "image/png.hpp"

#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <vector>

// libpng reports errors by longjmp: no object with a destructor is made between setjmp and the last
// call into it.

namespace meniscus::image {
namespace {

using Bytes = std::vector<png_byte>;

constexpr png_uint_32 largest_side = 1 << 16;

struct Stream {
    std::string bytes;        // written
    std::string_view unread;  // to read
    std::string error;
};

[[noreturn]] void on_error(png_structp png, png_const_charp message) {
    static_cast<Stream*>(png_get_error_ptr(png))->error = message;
    png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

void on_write(png_structp png, png_bytep data, std::size_t count) {
    static_cast<Stream*>(png_get_io_ptr(png))->bytes.append(reinterpret_cast<char*>(data), count);
}

void on_read(png_structp png, png_bytep data, std::size_t count) {
    auto& unread = static_cast<Stream*>(png_get_io_ptr(png))->unread;
    if (unread.size() < count) png_error(png, "the file ends early");
    std::memcpy(data, unread.data(), count);
    unread.remove_prefix(count);
}

struct WriteHandle {
    explicit WriteHandle(Stream& stream)
        : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, &stream, on_error, on_warning)),
          info(png_create_info_struct(png)) {
        png_set_write_fn(png, &stream, on_write, nullptr);
    }
    ~WriteHandle() { png_destroy_write_struct(&png, &info); }
    png_structp png;
    png_infop info;
};

struct ReadHandle {
    explicit ReadHandle(Stream& stream)
        : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &stream, on_error, on_warning)),
          info(png_create_info_struct(png)) {
        png_set_read_fn(png, &stream, on_read);
        png_set_user_limits(png, largest_side, largest_side);
    }
    ~ReadHandle() { png_destroy_read_struct(&png, &info, nullptr); }
    png_structp png;
    png_infop info;
};

bool is_ascii(const std::string& text) {
    return std::ranges::all_of(text, [](unsigned char c) { return c < 128; });
}

/// Texts that point into the metadata.
std::vector<png_text> make_texts(const Metadata& metadata) {
    std::vector<png_text> texts;
    for (const auto& [key, value] : metadata) {
        png_text text{};
        text.compression = is_ascii(value) ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
        text.key = const_cast<char*>(key.c_str());
        text.text = const_cast<char*>(value.c_str());
        texts.push_back(text);
    }
    return texts;
}

/// Rows of the full picture, big-endian.
Bytes quantized_rows(const Image& image, const PngOptions& options) {
    const std::size_t bytes_each = options.bits / 8;
    const unsigned max = options.bits == 16 ? 65535 : 255;
    Bytes rows(3 * bytes_each * image.full_width * image.full_height);
    for (int y = 0; y < image.height; ++y) {
        auto* out = rows.data() +
                    3 * bytes_each * (std::size_t(y + image.y0) * image.full_width + image.x0);
        const float* in = image.pixel(0, y);
        for (int i = 0; i < 3 * image.width; ++i) {
            const unsigned value = quantize(in[i], options.encoding, max);
            if (bytes_each == 2) *out++ = png_byte(value >> 8);
            *out++ = png_byte(value & 255);
        }
    }
    return rows;
}

bool write(WriteHandle& handle, png_uint_32 width, png_uint_32 height, const PngOptions& options,
           const std::vector<png_text>& texts, const Bytes& rows) {
    const auto png = handle.png;
    const auto info = handle.info;
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_user_limits(png, largest_side, largest_side);
    png_set_IHDR(png, info, width, height, options.bits, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (options.encoding == Encoding::linear)
        png_set_gAMA_fixed(png, info, PNG_FP_1);
    else
        png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    if (!texts.empty()) png_set_text(png, info, texts.data(), int(texts.size()));
    png_write_info(png, info);
    const std::size_t stride = rows.size() / height;
    for (png_uint_32 y = 0; y < height; ++y) png_write_row(png, rows.data() + y * stride);
    png_write_end(png, nullptr);
    return true;
}

struct Header {
    png_uint_32 width = 0, height = 0;
    int bits = 0;
    double file_gamma = 0.0;  // 0: sRGB
    png_textp texts = nullptr;
    int text_count = 0;
};

bool read_header(ReadHandle& handle, Header& header) {
    const auto png = handle.png;
    const auto info = handle.info;
    if (setjmp(png_jmpbuf(png))) return false;
    png_read_info(png, info);
    int intent;
    if (!png_get_sRGB(png, info, &intent)) png_get_gAMA(png, info, &header.file_gamma);
    png_get_text(png, info, &header.texts, &header.text_count);
    png_set_expand(png);
    png_set_strip_alpha(png);
    png_set_gray_to_rgb(png);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    header.width = png_get_image_width(png, info);
    header.height = png_get_image_height(png, info);
    header.bits = png_get_bit_depth(png, info);
    return true;
}

bool read_rows(ReadHandle& handle, const std::vector<png_bytep>& rows) {
    if (setjmp(png_jmpbuf(handle.png))) return false;
    png_read_image(handle.png, const_cast<png_bytepp>(rows.data()));
    return true;
}

std::vector<float> decoding_table(const Header& header) {
    std::vector<float> table(std::size_t(1) << header.bits);
    const double max = double(table.size() - 1);
    // A gamma of 1/2.2 is how files without the sRGB chunk mean the sRGB curve.
    const bool is_srgb = header.file_gamma == 0.0 || std::abs(header.file_gamma - 0.45455) < 1e-3;
    for (std::size_t i = 0; i < table.size(); ++i) {
        const double encoded = double(i) / max;
        table[i] =
            float(is_srgb ? srgb_decode(encoded) : std::pow(encoded, 1.0 / header.file_gamma));
    }
    return table;
}

}  // namespace

std::string encode_png(const Image& image, const PngOptions& options, const Metadata& metadata) {
    const auto rows = quantized_rows(image, options);
    const auto texts = make_texts(metadata);
    Stream stream;
    WriteHandle handle{stream};
    if (!write(handle, image.full_width, image.full_height, options, texts, rows))
        throw std::runtime_error("cannot make a PNG of this picture: " + stream.error);
    return std::move(stream.bytes);
}

Image decode_png(std::string_view bytes) {
    Stream stream;
    stream.unread = bytes;
    ReadHandle handle{stream};
    Header header;
    if (!read_header(handle, header)) throw std::runtime_error("not a PNG file: " + stream.error);

    const std::size_t bytes_each = header.bits / 8, stride = 3 * bytes_each * header.width;
    Bytes data(stride * header.height);
    std::vector<png_bytep> rows(header.height);
    for (std::size_t y = 0; y < rows.size(); ++y) rows[y] = data.data() + y * stride;
    if (!read_rows(handle, rows)) throw std::runtime_error("a broken PNG file: " + stream.error);

    Image image(int(header.width), int(header.height));
    const auto table = decoding_table(header);
    for (std::size_t i = 0; i < image.rgb.size(); ++i) {
        const auto* value = data.data() + i * bytes_each;
        image.rgb[i] = table[bytes_each == 2 ? value[0] << 8 | value[1] : value[0]];
    }
    return image;
}

PngHeader decode_png_header(std::string_view bytes) {
    Stream stream;
    stream.unread = bytes;
    ReadHandle handle{stream};
    Header header;
    if (!read_header(handle, header)) throw std::runtime_error("not a PNG file: " + stream.error);
    PngHeader result{.bits = header.bits, .metadata = {}};
    for (int i = 0; i < header.text_count; ++i)
        result.metadata[header.texts[i].key] = header.texts[i].text;
    return result;
}

}  // namespace meniscus::image
