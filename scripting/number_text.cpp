#include "scripting/number_text.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace demlua::scripting {

std::string grouped(std::uint64_t number) {
    std::string text = std::to_string(number);
    for (std::size_t tail = 3; tail < text.size(); tail += 4) text.insert(text.size() - tail, ",");
    return text;
}

std::string counted(std::uint64_t number, std::string_view noun) {
    return fmt::format("{} {}{}", grouped(number), noun, number == 1 ? "" : "s");
}

std::string with_prefix(double value, std::string_view unit) {
    struct Prefix {
        double factor;
        std::string_view text;
    };
    constexpr std::array<Prefix, 7> prefixes{
        {{1e9, "G"}, {1e6, "M"}, {1e3, "k"}, {1.0, ""}, {1e-3, "m"}, {1e-6, "u"}, {1e-9, "n"}}};
    if (value == 0.0 || !std::isfinite(value)) return fmt::format("{} {}", value, unit);
    for (const Prefix& prefix : prefixes) {
        // Half a unit in the fourth digit early, so that 0.99999 becomes "1" and not "1000 m".
        if (std::abs(value) >= 0.99995 * prefix.factor) {
            return fmt::format("{:.4g} {}{}", value / prefix.factor, prefix.text, unit);
        }
    }
    return fmt::format("{:.4g} {}", value, unit);
}

std::string duration(double seconds) {
    if (seconds < 59.95) return fmt::format("{:.{}f} s", seconds, seconds < 1.0 ? 2 : 1);
    const auto whole = static_cast<std::uint64_t>(std::llround(seconds));
    if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
    return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

} // namespace demlua::scripting
