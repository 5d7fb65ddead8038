// Everything a run writes while it runs, written on a thread of its own.
#pragma once

#include "engine/observe/snapshot.hpp"
#include "engine/output/history.hpp"
#include "engine/output/run_folder.hpp"
#include "engine/output/series.hpp"
#include "engine/output/text_file.hpp"

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <variant>

namespace demlua::output {

/// Takes frames, history rows and log lines and returns at once; a caller waits only when the thread is far behind. When
/// something cannot be written the next call, or drain(), throws RunError with the reason, and nothing more is written
/// but the summary.
class Writer {
public:
    /// `folder` has been opened. Throws RunError when the log cannot be made.
    explicit Writer(const RunFolder& folder);
    ~Writer();
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    Writer(Writer&&) = delete;
    Writer& operator=(Writer&&) = delete;

    void frame(observe::Snapshot snapshot);
    void history(observe::HistoryRow row);
    /// Never throws: what goes wrong here comes out at the next frame, row or drain().
    void log(std::chrono::system_clock::time_point when, std::string text);

    /// Waits until all is written.
    void drain();
    /// Waits, then writes summary.json. Writes it even when something else could not be written; throws RunError only
    /// when the summary itself cannot.
    void finish(const std::string& summary);

    /// Processor time that writing has taken, s; after drain().
    [[nodiscard]] double busy_time() const { return busy_time_; }
    /// Frames written; after drain().
    [[nodiscard]] std::size_t frames() const { return elements_.size(); }
    /// Whether there is a series of bonds; after drain().
    [[nodiscard]] bool has_bonds() const { return bonds_.size() > 0; }
    /// Whether there is a series of cracks, be there any or not; after drain().
    [[nodiscard]] bool has_cracks() const { return cracks_.size() > 0; }
    /// Whether there is a series of walls; after drain().
    [[nodiscard]] bool has_walls() const { return walls_.size() > 0; }

private:
    struct LogLine {
        std::chrono::system_clock::time_point when;
        std::string text;
    };
    using Job = std::variant<observe::Snapshot, observe::HistoryRow, LogLine>;

    void push(Job job);
    void work();
    void work_on(const Job& job);
    void write(const observe::Snapshot& snapshot);
    void write(const observe::HistoryRow& row);
    void write(const LogLine& line);
    void wait_until_idle();
    void throw_failure() const;

    RunFolder folder_;
    Series elements_;
    Series bonds_;
    Series cracks_;
    Series walls_;
    TextFile log_;
    std::optional<HistoryFile> history_;
    double busy_time_ = 0.0;

    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Job> queue_;
    std::size_t frames_waiting_ = 0;
    bool busy_ = false;
    bool closing_ = false;
    std::string failure_;
    std::thread thread_;
};

} // namespace demlua::output
