// A value a scene sets beside what it should be.
#pragma once

#include <optional>
#include <string>

namespace demlua::model {

struct Comparison {
    std::string what;
    std::string unit;
    double value = 0.0;
    double reference = 0.0;
    std::optional<double> tolerance; ///< greatest relative error, or difference where the reference is zero; positive
    std::string because;             ///< why the tolerance is what it is
    std::string source;              ///< of the reference
};

} // namespace demlua::model
