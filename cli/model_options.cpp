#include "cli/model_options.hpp"

#include <fmt/format.h>

namespace meniscus::cli {

void print_film(const std::optional<povray::Thickness>& thickness) {
    if (!thickness) return fmt::print(stderr, "no films: no solid cuts another\n");
    fmt::print(stderr, "films {:.6g} to {:.6g} scene units thick\n", thickness->least,
               thickness->largest);
}

}  // namespace meniscus::cli
