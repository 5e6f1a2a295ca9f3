#include "compare/pixel_data.hpp"

#include <zlib.h>

#include <bit>
#include <cstdint>
#include <stdexcept>

namespace meniscus::compare {

std::string pack(const image::Image& reference, const image::Image& picture) {
    const std::size_t count = reference.rgb.size();
    std::string bytes(8 * count, '\0');
    for (std::size_t i = 0; i < count; ++i) {
        const auto a = std::bit_cast<std::uint32_t>(reference.rgb[i]);
        const auto b = std::bit_cast<std::uint32_t>(picture.rgb[i]) ^ a;
        for (std::size_t k = 0; k < 4; ++k) {
            bytes[k * count + i] = char(a >> (8 * k) & 255);
            bytes[(4 + k) * count + i] = char(b >> (8 * k) & 255);
        }
    }
    auto size = ::compressBound(bytes.size());
    std::string packed(size, '\0');
    const int result = ::compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                                   reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), 9);
    if (result != Z_OK) throw std::runtime_error("zlib cannot compress the pictures");
    packed.resize(size);
    return packed;
}

}  // namespace meniscus::compare
