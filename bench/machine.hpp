#pragma once

#include <string>

namespace meniscus::bench {

/// The processor's name, its cores and the widest vectors that it knows: "AMD EPYC, 2 cores,
/// AVX-512".
std::string machine_name();

}  // namespace meniscus::bench
