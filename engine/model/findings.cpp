#include "engine/model/findings.hpp"

#include "engine/model/setting.hpp"

#include <cmath>

namespace demlua::model {

void check_signal(const std::optional<Signal>& signal, const std::string& what, const Place& place,
                  Findings& findings) {
    if (!signal) return;
    for (std::size_t k = 0; k < signal->times.size(); ++k) {
        if (!std::isfinite(signal->times[k]) || !std::isfinite(signal->values[k])) {
            findings.add(place, what, "", "times and values must be finite, item " + std::to_string(k + 1) + " is not");
            return;
        }
        if (k > 0 && signal->times[k] <= signal->times[k - 1]) {
            findings.add(place, what, text_of(signal->times[k]) + " s after " + text_of(signal->times[k - 1]) + " s",
                         "times must rise");
            return;
        }
    }
}

} // namespace demlua::model
