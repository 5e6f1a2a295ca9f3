#pragma once

namespace meniscus::cli {

inline constexpr const char* version = MENISCUS_VERSION;

}  // namespace meniscus::cli
