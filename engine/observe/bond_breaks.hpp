// Bonds that have broken, one by one, for those who want to hear of each.
#pragma once

#include "engine/base/vec2.hpp"
#include "engine/state/state.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace demlua::observe {

class Simulation;

/// One bond that broke.
struct BondBreak {
    double time = 0.0; ///< when it broke, s
    Vec2 place;        ///< where the parts of its length met that belong to its two elements, now, m
    Index i = 0;       ///< its elements, by number; i < j
    Index j = 0;
    std::string body;
};

/// Finds the bonds that broke between one look and the next. While none does, a look compares two counts.
class BreakWatch {
public:
    /// The bonds that broke since the last call, body by body in the order of their rows. The first call gives none: what
    /// is broken by then, a notch for instance, did not break under the eyes of this watch.
    std::vector<BondBreak> fresh(const Simulation& simulation);

private:
    bool begun_ = false;
    std::size_t count_ = 0;
    std::vector<Column<std::uint8_t>> broken_; ///< as last seen, a column to a set of bonds
};

} // namespace demlua::observe
