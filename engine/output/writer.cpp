#include "engine/output/writer.hpp"

#include "engine/base/problems.hpp"
#include "engine/output/vtu.hpp"
#include "engine/output/whole_file.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <exception>
#include <utility>

namespace demlua::output {

namespace {

/// Frames may be large: a few waiting are enough to keep the thread busy.
constexpr std::size_t most_frames_waiting = 3;
constexpr std::size_t most_jobs_waiting = 4096;

bool is_frame(const auto& job) { return std::holds_alternative<observe::Snapshot>(job); }

/// Processor time of this thread, s: what it takes from others, however long it has had to wait for a processor.
double processor_time() {
    std::timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::string stamped(std::chrono::system_clock::time_point when, const std::string& text) {
    const auto milliseconds =
        std::chrono::duration_cast<std::chrono::milliseconds>(when.time_since_epoch()).count() % 1000;
    return fmt::format("{:%Y-%m-%d %H:%M:%S}.{:03}  {}", fmt::localtime(std::chrono::system_clock::to_time_t(when)),
                       milliseconds, text);
}

} // namespace

Writer::Writer(const RunFolder& folder)
    : folder_(folder), elements_(folder.path(), names::elements), bonds_(folder.path(), names::bonds),
      cracks_(folder.path(), names::cracks), walls_(folder.path(), names::walls), log_(folder.file(names::log)),
      thread_([this] { work(); }) {}

Writer::~Writer() {
    {
        const std::lock_guard lock(mutex_);
        closing_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void Writer::frame(observe::Snapshot snapshot) { push(std::move(snapshot)); }

void Writer::history(observe::HistoryRow row) { push(std::move(row)); }

void Writer::log(std::chrono::system_clock::time_point when, std::string text) {
    const std::lock_guard lock(mutex_);
    if (!failure_.empty()) return;
    queue_.emplace_back(LogLine{when, std::move(text)});
    changed_.notify_all();
}

void Writer::push(Job job) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] {
        return !failure_.empty() ||
               (queue_.size() < most_jobs_waiting && (!is_frame(job) || frames_waiting_ < most_frames_waiting));
    });
    throw_failure();
    if (is_frame(job)) ++frames_waiting_;
    queue_.push_back(std::move(job));
    changed_.notify_all();
}

void Writer::drain() {
    wait_until_idle();
    const std::lock_guard lock(mutex_);
    throw_failure();
}

void Writer::finish(const std::string& summary) {
    wait_until_idle();
    replace_file(folder_.file(names::summary), summary);
}

void Writer::wait_until_idle() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return queue_.empty() && !busy_; });
}

void Writer::throw_failure() const {
    if (!failure_.empty()) throw RunError(failure_);
}

void Writer::work() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [&] { return closing_ || !queue_.empty(); });
        if (queue_.empty()) return;
        const Job job = std::move(queue_.front());
        queue_.pop_front();
        if (is_frame(job)) --frames_waiting_;
        busy_ = true;
        lock.unlock();
        changed_.notify_all();
        work_on(job);
        lock.lock();
        busy_ = false;
        changed_.notify_all();
    }
}

void Writer::work_on(const Job& job) {
    const double begin = processor_time();
    try {
        std::visit([this](const auto& what) { write(what); }, job);
    } catch (const std::exception& error) {
        const std::lock_guard lock(mutex_);
        failure_ = error.what();
        queue_.clear();
        frames_waiting_ = 0;
    }
    busy_time_ += processor_time() - begin;
}

void Writer::write(const observe::Snapshot& snapshot) {
    elements_.add(snapshot.time, elements_vtu(snapshot));
    if (!snapshot.bond_ends.empty()) bonds_.add(snapshot.time, bonds_vtu(snapshot));
    if (!snapshot.crack_fields.empty()) cracks_.add(snapshot.time, cracks_vtu(snapshot));
    if (!snapshot.wall_fields.empty()) walls_.add(snapshot.time, walls_vtu(snapshot));
}

void Writer::write(const observe::HistoryRow& row) {
    if (!history_) history_.emplace(folder_.file(names::history));
    history_->add(row);
}

void Writer::write(const LogLine& line) { log_.line(stamped(line.when, line.text)); }

} // namespace demlua::output
