#include "image/save.hpp"

#include <algorithm>
#include <cctype>

namespace meniscus::image {

std::optional<Format> format_of(const std::filesystem::path& path) {
    if (path == standard_stream) return Format::png;
    auto extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return std::tolower(c); });
    if (extension == ".png") return Format::png;
    if (extension == ".exr") return Format::exr;
    return std::nullopt;
}

void save(const Image& image, const std::filesystem::path& path, const SaveOptions& options,
          const Metadata& metadata) {
    write_file(path, options.format == Format::exr ? encode_exr(image, options.exr, metadata)
                                                   : encode_png(image, options.png, metadata));
}

Image load(const std::filesystem::path& path) { return load_with_header(path).image; }

Loaded load_with_header(const std::filesystem::path& path) {
    const auto bytes = read_file(path);
    try {
        if (bytes.starts_with("\x89PNG")) {
            const auto header = decode_png_header(bytes);
            return {decode_png(bytes), Format::png, header.bits, header.metadata};
        }
        if (bytes.starts_with("\x76\x2f\x31\x01")) {
            const auto header = decode_exr_header(bytes);
            return {decode_exr(bytes), Format::exr, header.half ? 16 : 32, header.metadata};
        }
    } catch (const std::exception& error) {
        throw FileError(path, error.what());
    }
    throw FileError(path, "cannot read: neither PNG nor OpenEXR");
}

}  // namespace meniscus::image
