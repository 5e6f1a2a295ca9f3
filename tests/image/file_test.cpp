#include "image/file.hpp"

#include <sys/resource.h>
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <csignal>

#include "image/save.hpp"
#include "tests/image/scratch.hpp"

using namespace meniscus::image;
namespace fs = std::filesystem;

namespace {

/// No file may grow beyond `bytes` while this lives: writing fails as on a full disk.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;
    ~FullDisk() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

private:
    rlimit before_{};
    void (*handler_)(int);
};

}  // namespace

TEST_CASE("a written file holds the bytes and nothing stands beside it", "[image]") {
    const Scratch folder;
    write_file(folder / "a.png", "one");
    write_file(folder / "a.png", "two");
    CHECK(read_file(folder / "a.png") == "two");
    CHECK(folder.files() == 1);
}

TEST_CASE("a failing write leaves the old file untouched and no other behind", "[image]") {
    const Scratch folder;
    write_file(folder / "a.png", "old");
    {
        const FullDisk full{1000};
        CHECK_THROWS_AS(write_file(folder / "a.png", std::string(5000, 'x')), FileError);
    }
    CHECK(read_file(folder / "a.png") == "old");
    CHECK(folder.files() == 1);
}

TEST_CASE("a link stays a link and the file keeps its mode", "[image]") {
    const Scratch folder;
    write_file(folder / "real.png", "old");
    ::chmod((folder / "real.png").c_str(), 0640);
    fs::create_symlink("real.png", folder / "link.png");
    write_file(folder / "link.png", "new");
    CHECK(fs::is_symlink(folder / "link.png"));
    CHECK(read_file(folder / "real.png") == "new");
    fs::create_symlink("later.png", folder / "early.png");
    write_file(folder / "early.png", "first");
    CHECK(fs::is_symlink(folder / "early.png"));
    CHECK(read_file(folder / "later.png") == "first");
    CHECK((fs::status(folder / "real.png").permissions() & fs::perms::mask) == fs::perms(0640));
}

TEST_CASE("a device is written to, not replaced", "[image]") {
    write_file("/dev/null", "gone");
    CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("an unwritable target is known before writing", "[image]") {
    const Scratch folder;
    CHECK_NOTHROW(check_writable(folder / "a.png"));
    CHECK(folder.files() == 0);
    CHECK_THROWS_AS(check_writable(folder / "absent" / "a.png"), FileError);
    CHECK_THROWS_AS(check_writable(folder.path()), FileError);
    CHECK_NOTHROW(check_writable("-"));
}

TEST_CASE("errors name the file", "[image]") {
    CHECK_THROWS_WITH(load("no such picture.png"), Catch::Contains("no such picture.png"));
    const Scratch folder;
    write_file(folder / "text.png", "not a picture");
    CHECK_THROWS_WITH(load(folder / "text.png"), Catch::Contains("neither PNG nor OpenEXR"));
    write_file(folder / "cut.png", "\x89PNG\r\n\x1a\n");
    CHECK_THROWS_AS(load(folder / "cut.png"), FileError);
    write_file(folder / "cut.exr", "\x76\x2f\x31\x01");
    CHECK_THROWS_AS(load(folder / "cut.exr"), FileError);
}

TEST_CASE("the extension chooses the format", "[image]") {
    CHECK(format_of("a.png") == Format::png);
    CHECK(format_of("a.b/c.EXR") == Format::exr);
    CHECK(format_of("-") == Format::png);
    CHECK_FALSE(format_of("a.jpg"));
    CHECK_FALSE(format_of("png"));
}

TEST_CASE("save and load are each other's inverse in both formats", "[image]") {
    const Scratch folder;
    Image image(3, 2);
    image.pixel(1, 1)[2] = 1.0f;
    for (const auto* name : {"a.png", "a.exr"}) {
        save(image, folder / name, {.format = *format_of(name), .png = {}, .exr = {}}, {});
        CHECK(load(folder / name).rgb == image.rgb);
    }
}
