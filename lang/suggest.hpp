#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace meniscus::lang {

/// "; did you mean 'sphere'?" if one of the words is near, else nothing.
std::string suggestion(std::string_view word, std::span<const std::string_view> known);
std::string suggestion(std::string_view word, const std::vector<std::string>& known);

}  // namespace meniscus::lang
