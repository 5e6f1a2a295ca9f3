#include "povray/scratch.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "image/file.hpp"

namespace meniscus::povray {

Scratch::Scratch() {
    auto name = (std::filesystem::temp_directory_path() / "meniscus-povray-XXXXXX").string();
    if (!::mkdtemp(name.data())) {
        throw image::FileError(name,
                               std::string("cannot make a temporary folder: ") + strerror(errno));
    }
    path_ = name;
}

Scratch::~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

}  // namespace meniscus::povray
