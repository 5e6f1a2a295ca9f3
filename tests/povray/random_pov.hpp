#pragma once

#include <cstdint>
#include <string>

namespace meniscus::test {

/// A scene in POV-Ray's own language, of all that we claim to render as POV-Ray does: cameras,
/// lights, shapes, patterns, finishes, glass that touches nothing. The same text for the same seed.
std::string random_pov(std::uint64_t seed);

}  // namespace meniscus::test
