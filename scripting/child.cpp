#include "scripting/child.hpp"

#include "engine/base/problems.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace demlua::scripting {

namespace {

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Where the child's words go, and its own process group.
class Surroundings {
public:
    explicit Surroundings(const std::filesystem::path& complaints) {
        posix_spawn_file_actions_init(&files_);
        posix_spawn_file_actions_addopen(&files_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&files_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_addopen(&files_, STDERR_FILENO, complaints.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                         0644);
        posix_spawnattr_init(&attributes_);
        posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP);
    }
    ~Surroundings() {
        posix_spawn_file_actions_destroy(&files_);
        posix_spawnattr_destroy(&attributes_);
    }
    Surroundings(const Surroundings&) = delete;
    Surroundings& operator=(const Surroundings&) = delete;
    Surroundings(Surroundings&&) = delete;
    Surroundings& operator=(Surroundings&&) = delete;

    [[nodiscard]] const posix_spawn_file_actions_t* files() const { return &files_; }
    [[nodiscard]] const posix_spawnattr_t* attributes() const { return &attributes_; }

private:
    posix_spawn_file_actions_t files_{};
    posix_spawnattr_t attributes_{};
};

} // namespace

std::filesystem::path own_program() {
    std::error_code failed;
    std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", failed);
    if (failed) throw RunError("the program cannot find its own file: " + failed.message());
    return program;
}

void Child::start(const std::vector<std::string>& arguments, const std::filesystem::path& complaints) {
    const std::string program = own_program().string();
    std::vector<std::string> words{program};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    argv.reserve(words.size() + 1);
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const Surroundings surroundings(complaints);
    begin_ = now();
    pid_t process = 0;
    const int failed =
        posix_spawn(&process, program.c_str(), surroundings.files(), surroundings.attributes(), argv.data(), environ);
    if (failed != 0) throw RunError(fmt::format("{} cannot be started: {}", program, std::strerror(failed)));
    asked_to_end_ = false;
    process_ = process;
}

ChildEnd Child::wait() {
    int status = 0;
    rusage use{};
    while (wait4(process_, &status, 0, &use) < 0) {
        if (errno != EINTR) throw RunError(fmt::format("a run was lost: {}", std::strerror(errno)));
    }
    process_ = 0;
    ChildEnd end;
    end.wall_time = now() - begin_;
    end.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    end.peak_memory = static_cast<double>(use.ru_maxrss) * 1024.0; // Linux counts it in KiB
    return end;
}

void Child::interrupt() {
    const pid_t process = process_;
    // A second signal would end it before it has written its last frame.
    if (process > 0 && !asked_to_end_.exchange(true)) kill(process, SIGINT);
}

} // namespace demlua::scripting
