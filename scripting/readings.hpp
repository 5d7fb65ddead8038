// What `now` and events can be asked, as rows: name, unit, meaning, where it comes from. The reader and the manual follow from them.
#pragma once

#include "engine/observe/bond_breaks.hpp"
#include "engine/observe/simulation.hpp"

#include <string>
#include <variant>
#include <vector>

namespace demlua::scripting {

template <class Source>
struct Reading {
    std::string name;
    std::string unit;
    std::string meaning;
    std::variant<double (*)(const Source&), Vec2 (*)(const Source&), std::string (*)(const Source&)> get;
};

const std::vector<Reading<observe::Simulation>>& now_readings();
const std::vector<Reading<observe::Ledger>>& ledger_readings();
const std::vector<Reading<observe::Momentum>>& momentum_readings();
const std::vector<Reading<observe::WallMotion>>& wall_readings();
const std::vector<Reading<observe::BodyMotion>>& body_readings();
const std::vector<Reading<observe::BondBreak>>& break_readings();

} // namespace demlua::scripting
