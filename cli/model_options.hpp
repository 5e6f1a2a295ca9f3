#pragma once

#include <optional>

#include "povray/film.hpp"

namespace meniscus::cli {

/// How thick the films of the gap model really are, on standard error.
void print_film(const std::optional<povray::Thickness>& thickness);

}  // namespace meniscus::cli
