// Numbers as people read them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace demlua::scripting {

/// 12345 as "12,345".
std::string grouped(std::uint64_t number);

/// "1 bond", "12,345 bonds".
std::string counted(std::uint64_t number, std::string_view noun);

/// Four digits and a prefix: (0.0026712, "s") as "2.671 ms".
std::string with_prefix(double value, std::string_view unit);

/// Wall time: "0.31 s", "12.4 s", "3 min 20 s", "2 h 5 min".
std::string duration(double seconds);

} // namespace demlua::scripting
