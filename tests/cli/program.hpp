#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "image/file.hpp"
#include "tests/image/scratch.hpp"

/// The program, run in a folder of its own with two scenes in it.
class Program {
public:
    Program() {
        write("ball.scene", R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 right x * image_width / image_height }
background { color rgb <0.2, 0.5, 0.9> }
light_source { <3, 5, -6> color rgb 1 }
sphere { <0, 0, 0>, 1 material { ior 1.5 } }
)");
        write("wrong.scene", "spere { <0, 0, 0>, 1 }\n");
    }

    struct Result {
        int exit_code;
        std::string out, err;
    };

    /// The arguments go through a shell.
    Result run(const std::string& arguments) const {
        return shell(MENISCUS_BINARY " " + arguments);
    }

    Result shell(const std::string& command) const {
        const auto full = "cd '" + folder_.path().string() + "' && " + command + " >out 2>err";
        const int status = std::system(full.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read("out"),
                read("err")};
    }

    void write(const std::string& name, const std::string& text) const {
        meniscus::image::write_file(folder_ / name, text);
    }
    std::string read(const std::string& name) const {
        return meniscus::image::read_file(folder_ / name);
    }
    bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
    std::filesystem::path path(const std::string& name) const { return folder_ / name; }

private:
    Scratch folder_;
};
