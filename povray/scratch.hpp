#pragma once

#include <filesystem>
#include <string>

namespace meniscus::povray {

/// A folder of its own under the system's temporary one, gone with the object.
class Scratch {
public:
    Scratch();
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    ~Scratch();

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

private:
    std::filesystem::path path_;
};

}  // namespace meniscus::povray
