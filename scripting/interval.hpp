// How often something is written, which a scene may change as it goes.
#pragma once

#include <cmath>
#include <memory>
#include <optional>

namespace demlua::scripting {

/// A run's time step is fitted to the interval first said, whatever it is changed to: a change decides what is written,
/// never how things move. Times in s.
class Interval {
public:
    explicit Interval(double said) : said_(said) {}

    [[nodiscard]] double said() const { return said_; }
    [[nodiscard]] bool changed() const { return changed_.has_value(); }

    /// From now on every `every`, first that long after `now`.
    void change(double every, double now) { changed_ = Changed{every, now, 1.0}; }
    /// A run begins: the count does too, with its first instant.
    void begin(double now) {
        if (changed_) changed_ = Changed{changed_->every, now, 0.0};
    }
    /// Whether a changed interval has come round; it is then counted.
    bool comes_round(double now, double tolerance) {
        if (!changed_ || now < changed_->since + changed_->next * changed_->every - tolerance) return false;
        changed_->next = std::floor((now + tolerance - changed_->since) / changed_->every) + 1.0;
        return true;
    }

private:
    struct Changed {
        double every = 0.0;
        double since = 0.0;
        double next = 0.0; ///< which one is due, a whole number
    };

    double said_;
    std::optional<Changed> changed_;
};

/// Shared by the scene's handle, which changes it, and by the runs it is in force for.
using SharedInterval = std::shared_ptr<Interval>;

} // namespace demlua::scripting
