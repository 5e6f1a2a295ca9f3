#pragma once

#include <string>
#include <vector>

namespace meniscus::cli {

/// POV-Ray's switches and settings among the arguments, spelled as our own options: "+W320" becomes
/// "--width", "320". What POV-Ray knows and we do not is refused with a `UsageError`. `meniscus
/// +Iglass.pov` alone means `render`.
std::vector<std::string> translate_povray_spellings(const std::vector<std::string>& arguments);

}  // namespace meniscus::cli
