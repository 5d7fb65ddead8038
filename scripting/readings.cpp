#include "scripting/readings.hpp"

namespace demlua::scripting {

using observe::BodyMotion;
using observe::BondBreak;
using observe::Ledger;
using observe::Momentum;
using observe::Simulation;
using observe::WallMotion;

namespace {

double number(std::size_t count) { return static_cast<double>(count); }

template <double Ledger::*share>
double energy(const Ledger& ledger) {
    return ledger.*share;
}

} // namespace

const std::vector<Reading<Simulation>>& now_readings() {
    static const std::vector<Reading<Simulation>> rows{
        {"time", "s", "since the start of the first run", [](const Simulation& s) { return s.time(); }},
        {"step", "", "steps taken so far", [](const Simulation& s) { return static_cast<double>(s.step()); }},
        {"time_step", "s", "length of a step", [](const Simulation& s) { return s.time_step(); }},
        {"elements", "", "how many there are", [](const Simulation& s) { return number(s.element_count()); }},
        {"bonds", "", "how many there were at the start", [](const Simulation& s) { return number(s.bond_count()); }},
        {"broken_bonds", "", "how many of them are broken",
         [](const Simulation& s) { return number(s.broken_bonds()); }},
        {"crack_length", "m", "sum over broken bonds of their facets, or else of the mean diameter of their elements",
         [](const Simulation& s) { return s.crack_length(); }},
        {"surface_energy", "J", "what broken bonds took: their plastic work and what they still held",
         [](const Simulation& s) { return s.surface_energy(); }},
        {"fragments", "", "parts held together by bonds", [](const Simulation& s) { return number(s.fragments()); }},
        {"contacts", "", "that touch", [](const Simulation& s) { return number(s.contact_count()); }},
        {"worn", "", "elements that wear has taken out of their clusters",
         [](const Simulation& s) { return number(s.worn_elements()); }},
        {"removed", "", "elements that left the domain",
         [](const Simulation& s) { return number(s.removed_elements()); }},
    };
    return rows;
}

const std::vector<Reading<Ledger>>& ledger_readings() {
    static const std::vector<Reading<Ledger>> rows{
        {"kinetic", "J", "of motion and spin", energy<&Ledger::kinetic>},
        {"bonds", "J", "stored in bonds", energy<&Ledger::bonds>},
        {"contacts", "J", "stored in contacts", energy<&Ledger::contacts>},
        {"potential", "J", "in gravity, zero at the start", energy<&Ledger::potential>},
        {"plastic", "J", "spent by yielding bonds", energy<&Ledger::plastic>},
        {"fracture", "J", "stored in bonds when they broke", energy<&Ledger::fracture>},
        {"friction", "J", "spent by sliding contacts", energy<&Ledger::friction>},
        {"bond_damping", "J", "spent by the bonds' dashpots", energy<&Ledger::bond_damping>},
        {"contact_damping", "J", "spent by the contacts' dashpots", energy<&Ledger::contact_damping>},
        {"mass_damping", "J", "spent by mass-proportional damping", energy<&Ledger::mass_damping>},
        {"removed", "J", "of elements that left the domain", energy<&Ledger::removed>},
        {"work", "J", "done by loads, prescribed motions and walls", energy<&Ledger::work>},
        {"error", "J", "what all these leave unexplained", energy<&Ledger::error>},
    };
    return rows;
}

const std::vector<Reading<Momentum>>& momentum_readings() {
    static const std::vector<Reading<Momentum>> rows{
        {"x", "kg m/s", "along x", [](const Momentum& m) { return m.linear.x; }},
        {"y", "kg m/s", "along y", [](const Momentum& m) { return m.linear.y; }},
        {"angular", "kg m^2/s", "about the origin", [](const Momentum& m) { return m.angular; }},
    };
    return rows;
}

const std::vector<Reading<BodyMotion>>& body_readings() {
    static const std::vector<Reading<BodyMotion>> rows{
        {"mass", "kg", "", [](const BodyMotion& m) { return m.mass; }},
        {"position", "m", "x and y of the centre of mass", [](const BodyMotion& m) { return m.centre; }},
        {"velocity", "m/s", "x and y, of the centre of mass", [](const BodyMotion& m) { return m.velocity; }},
        {"spin", "rad/s", "about the centre of mass", [](const BodyMotion& m) { return m.spin; }},
        {"lowest", "m", "y of its lowest point", [](const BodyMotion& m) { return m.extent.lower.y; }},
        {"highest", "m", "y of its highest point", [](const BodyMotion& m) { return m.extent.upper.y; }},
        {"leftmost", "m", "x of its leftmost point", [](const BodyMotion& m) { return m.extent.lower.x; }},
        {"rightmost", "m", "x of its rightmost point", [](const BodyMotion& m) { return m.extent.upper.x; }},
    };
    return rows;
}

const std::vector<Reading<WallMotion>>& wall_readings() {
    static const std::vector<Reading<WallMotion>> rows{
        {"position", "m", "x and y of what it turns about; of an outline's centre of mass",
         [](const WallMotion& m) { return m.position; }},
        {"velocity", "m/s", "x and y", [](const WallMotion& m) { return m.velocity; }},
        {"angle", "rad", "turned since the start", [](const WallMotion& m) { return m.angle; }},
        {"spin", "rad/s", "counter-clockwise", [](const WallMotion& m) { return m.spin; }},
        {"force", "N", "x and y, of elements and outlines on it", [](const WallMotion& m) { return m.force; }},
        {"moment", "N m", "of the elements on it, about its position", [](const WallMotion& m) { return m.moment; }},
        {"stress", "Pa",
         "x over its height and y over its width, positive where it presses towards the side on which the middle of "
         "all "
         "elements lay when its motion was said; 0 for one without height or width",
         [](const WallMotion& m) { return m.stress; }},
        {"mass", "kg", "of an outline, else 0", [](const WallMotion& m) { return m.mass; }},
        {"inertia", "kg m^2", "of an outline about its centre of mass, else 0",
         [](const WallMotion& m) { return m.inertia; }},
    };
    return rows;
}

const std::vector<Reading<BondBreak>>& break_readings() {
    static const std::vector<Reading<BondBreak>> rows{
        {"time", "s", "when the bond broke", [](const BondBreak& b) { return b.time; }},
        {"x", "m", "of the place between its elements where it broke", [](const BondBreak& b) { return b.place.x; }},
        {"y", "m", "likewise", [](const BondBreak& b) { return b.place.y; }},
        {"i", "", "number of one element, its `id`", [](const BondBreak& b) { return number(b.i); }},
        {"j", "", "number of the other", [](const BondBreak& b) { return number(b.j); }},
        {"body", "", "name of the body it held together", [](const BondBreak& b) { return b.body; }},
    };
    return rows;
}

} // namespace demlua::scripting
