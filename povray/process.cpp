#include "povray/process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace meniscus::povray {
namespace {

/// What a child does to its files before it begins.
class FileActions {
public:
    FileActions() { posix_spawn_file_actions_init(&actions_); }
    FileActions(const FileActions&) = delete;
    FileActions& operator=(const FileActions&) = delete;
    ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }

    void open(int descriptor, const std::filesystem::path& path, int flags) {
        check(posix_spawn_file_actions_addopen(&actions_, descriptor, path.c_str(), flags, 0600));
    }
    void change_folder(const std::filesystem::path& path) {
        check(posix_spawn_file_actions_addchdir_np(&actions_, path.c_str()));
    }
    const posix_spawn_file_actions_t* get() const { return &actions_; }

private:
    static void check(int error) {
        if (error != 0) throw std::system_error(error, std::generic_category());
    }
    posix_spawn_file_actions_t actions_;
};

}  // namespace

std::optional<int> run_process(const std::vector<std::string>& command, const ProcessPlace& place) {
    FileActions actions;
    actions.open(STDIN_FILENO, "/dev/null", O_RDONLY);
    actions.open(STDOUT_FILENO, place.output, O_WRONLY | O_CREAT | O_TRUNC);
    actions.open(STDERR_FILENO, place.errors, O_WRONLY | O_CREAT | O_TRUNC);
    actions.change_folder(place.folder);

    std::vector<char*> words;
    for (const auto& word : command) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    pid_t child = 0;
    const int error = posix_spawnp(&child, words[0], actions.get(), nullptr, words.data(), environ);
    if (error == ENOENT) return std::nullopt;
    if (error != 0) throw std::system_error(error, std::generic_category(), command.front());

    int status = 0;
    while (waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "waitpid");
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace meniscus::povray
