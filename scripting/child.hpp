// This program run once more, as a process of its own.
#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include <sys/types.h>

namespace demlua::scripting {

/// How a child ended and what it took.
struct ChildEnd {
    int code = 0;             ///< exit code, or 128 and the signal that ended it
    double wall_time = 0.0;   ///< s
    double peak_memory = 0.0; ///< B
};

class Child {
public:
    /// Starts the program that is running with `arguments` in the same folder. What it says goes nowhere, its complaints
    /// go to the file `complaints`. It is in a process group of its own, so that Ctrl-C reaches it only by `interrupt`.
    /// Throws RunError with the system's reason.
    void start(const std::vector<std::string>& arguments, const std::filesystem::path& complaints);
    /// Waits until it has ended.
    ChildEnd wait();
    /// Asks it to end, once, from any thread; does nothing while none runs.
    void interrupt();

private:
    std::atomic<pid_t> process_{0};
    std::atomic<bool> asked_to_end_{false};
    double begin_ = 0.0; ///< s, on a steady clock
};

/// The file of the program that is running. Throws RunError.
std::filesystem::path own_program();

} // namespace demlua::scripting
