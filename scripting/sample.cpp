#include "scripting/sample.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>

namespace demlua::scripting {

namespace {

/// A stretch between neighbouring samples with the value half-way and how far a straight line misses it.
struct Stretch {
    double begin, end;
    double begin_value, middle_value, end_value;

    [[nodiscard]] double middle() const { return 0.5 * (begin + end); }
    [[nodiscard]] double miss() const { return std::abs(middle_value - 0.5 * (begin_value + end_value)); }
    friend bool operator<(const Stretch& a, const Stretch& b) { return a.miss() < b.miss(); }
};

class Sampler {
public:
    Sampler(const std::function<double(double)>& function, double begin, double end)
        : function_(function), shortest_(1e-9 * (end - begin)) {
        constexpr int first_stretches = 512; // enough not to step over what is not deliberately hidden
        double time = begin;
        double value = at(begin);
        for (int k = 1; k <= first_stretches; ++k) {
            const double next = k == first_stretches ? end : begin + (end - begin) * k / first_stretches;
            const double next_value = at(next);
            add(time, value, next, next_value);
            time = next;
            value = next_value;
        }
    }

    Sampled refined() {
        while (!open_.empty() && open_.top().miss() > sampling_tolerance * largest_ &&
               samples_.size() < greatest_sample_count) {
            const Stretch worst = open_.top();
            open_.pop();
            samples_[worst.middle()] = worst.middle_value;
            add(worst.begin, worst.begin_value, worst.middle(), worst.middle_value);
            add(worst.middle(), worst.middle_value, worst.end, worst.end_value);
        }
        Sampled result{{{}, {}}, open_.empty() || largest_ == 0.0 ? 0.0 : open_.top().miss() / largest_};
        for (const auto& [time, value] : samples_) {
            result.signal.times.push_back(time);
            result.signal.values.push_back(value);
        }
        return result;
    }

private:
    double at(double time) {
        const double value = function_(time);
        largest_ = std::max(largest_, std::abs(value));
        return value;
    }

    void add(double begin, double begin_value, double end, double end_value) {
        samples_[begin] = begin_value;
        samples_[end] = end_value;
        if (end - begin <= shortest_) return;
        open_.push({begin, end, begin_value, at(0.5 * (begin + end)), end_value});
    }

    const std::function<double(double)>& function_;
    double shortest_;
    double largest_ = 0.0;
    std::map<double, double> samples_;
    std::priority_queue<Stretch> open_;
};

/// Samples on a straight line between their neighbours say nothing; the first grid leaves many.
Signal thinned(const Signal& full) {
    double largest = 0.0;
    for (const double value : full.values) largest = std::max(largest, std::abs(value));
    const double tolerance = 1e-12 * largest;
    Signal thin{{}, {}};
    const std::size_t n = full.times.size();
    for (std::size_t k = 0; k < n; ++k) {
        if (k > 0 && k + 1 < n) {
            const double share = (full.times[k] - thin.times.back()) / (full.times[k + 1] - thin.times.back());
            const double straight = thin.values.back() + share * (full.values[k + 1] - thin.values.back());
            if (std::abs(full.values[k] - straight) <= tolerance) continue;
        }
        thin.times.push_back(full.times[k]);
        thin.values.push_back(full.values[k]);
    }
    return thin;
}

} // namespace

Sampled sample(const std::function<double(double)>& function, double begin, double end) {
    Sampled result = Sampler(function, begin, end).refined();
    result.signal = thinned(result.signal);
    return result;
}

} // namespace demlua::scripting
