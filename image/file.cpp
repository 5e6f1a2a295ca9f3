#include "image/file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace meniscus::image {
namespace {

namespace fs = std::filesystem;

std::string reason() { return std::strerror(errno); }

/// A file descriptor that closes itself.
class Descriptor {
public:
    explicit Descriptor(int fd) : fd_(fd) {}
    Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
    Descriptor& operator=(Descriptor&&) = delete;
    ~Descriptor() {
        if (fd_ >= 0) ::close(fd_);
    }
    explicit operator bool() const { return fd_ >= 0; }
    int get() const { return fd_; }
    bool close() { return ::close(std::exchange(fd_, -1)) == 0; }

private:
    int fd_;
};

bool write_all(int fd, std::string_view bytes) {
    while (!bytes.empty()) {
        const auto written = ::write(fd, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        bytes.remove_prefix(std::size_t(written));
    }
    return true;
}

/// A new file beside the target that goes away unless it takes the target's place.
class TemporaryFile {
public:
    explicit TemporaryFile(const fs::path& target) : target_(target), file_(create()) {}
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        if (!renamed_) ::unlink(name_.c_str());
    }

    void write(std::string_view bytes) {
        if (!write_all(file_.get(), bytes)) throw FileError(target_, "cannot write: " + reason());
    }
    void take_place() {
        if (!file_.close()) throw FileError(target_, "cannot write: " + reason());
        if (::rename(name_.c_str(), target_.c_str()) != 0)
            throw FileError(target_, "cannot rename the finished file: " + reason());
        renamed_ = true;
    }

private:
    Descriptor create() {
        struct stat old {};
        const bool exists = ::stat(target_.c_str(), &old) == 0;
        if (exists && ::access(target_.c_str(), W_OK) != 0)
            throw FileError(target_, "cannot write: " + reason());
        for (int attempt = 0;; ++attempt) {
            name_ = target_.string() + '.' + std::to_string(::getpid()) + '-' +
                    std::to_string(attempt) + ".tmp";
            Descriptor file{::open(name_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666)};
            if (!file && errno == EEXIST && attempt < 100) continue;
            if (!file) throw FileError(target_, "cannot write: " + reason());
            if (exists) (void)!::fchmod(file.get(), old.st_mode & 07777);
            return file;
        }
    }

    fs::path target_;
    std::string name_;
    Descriptor file_;
    bool renamed_ = false;
};

/// Where the bytes go in the end: a link stays a link.
fs::path resolve(const fs::path& path) {
    constexpr int longest_chain = 40;  // as Linux has it
    std::error_code ignored;
    fs::path place = path;
    for (int i = 0; i < longest_chain && fs::is_symlink(place, ignored); ++i)
        place = place.parent_path() / fs::read_symlink(place, ignored);  // which may be absolute
    return place;
}

/// A device or pipe, which must not be replaced by a file.
bool is_special(const fs::path& path) {
    std::error_code ignored;
    const auto status = fs::status(path, ignored);
    if (fs::is_directory(status)) throw FileError(path, "cannot write: it is a folder");
    return fs::exists(status) && !fs::is_regular_file(status);
}

}  // namespace

FileError::FileError(const fs::path& where, std::string_view why)
    : std::runtime_error((where == standard_stream ? "standard output" : where.string()) + ": " +
                         std::string(why)),
      path(where) {}

std::string read_file(const fs::path& path) {
    const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC)};
    if (!file) throw FileError(path, "cannot read: " + reason());
    std::string bytes;
    char block[1 << 16];
    for (;;) {
        const auto count = ::read(file.get(), block, sizeof block);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw FileError(path, "cannot read: " + reason());
        if (count == 0) return bytes;
        bytes.append(block, std::size_t(count));
    }
}

void write_file(const fs::path& path, std::string_view bytes) {
    if (path == standard_stream) {
        if (!write_all(STDOUT_FILENO, bytes)) throw FileError(path, "cannot write: " + reason());
        return;
    }
    const auto target = resolve(path);
    if (is_special(target)) {
        Descriptor device{::open(target.c_str(), O_WRONLY | O_CLOEXEC)};
        if (!device || !write_all(device.get(), bytes) || !device.close())
            throw FileError(path, "cannot write: " + reason());
        return;
    }
    TemporaryFile file{target};
    file.write(bytes);
    file.take_place();
}

void check_writable(const fs::path& path) {
    if (path == standard_stream) return;
    const auto target = resolve(path);
    if (!is_special(target)) TemporaryFile{target};
}

}  // namespace meniscus::image
