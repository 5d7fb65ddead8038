// Rows of what is done to bodies and what is asked of a run.
#include "engine/model/rows.hpp"
#include "engine/model/settings.hpp"

namespace demlua::model {

namespace words {

using namespace rows;

namespace {

const Names& driver_names() {
    static const Names names{"dynamic", "quasi-static"};
    return names;
}
const Names& rotation_names() {
    static const Names names{"free", "held"};
    return names;
}

/// Selections are said in one way everywhere: as first item of the table, narrowed by `within` and `where`.
template <auto selection>
std::vector<Row<OwnerOf<selection>>> selecting(std::vector<Row<OwnerOf<selection>>> others) {
    std::vector<Row<OwnerOf<selection>>> rows;
    rows.push_back(row<selection>("selection", optional, "which elements; the word itself may be left out").at(1));
    rows.push_back(row<selection, WithinSlot>("within", optional, "only elements whose centre lies in this region"));
    rows.push_back(row<selection, WhereSlot>("where", optional, "only elements for whose centre this is true"));
    for (auto& each : others) rows.push_back(std::move(each));
    return rows;
}

} // namespace

const WordOf<Support>& fix() {
    static const WordOf<Support> made =
        word<Support>("sim:fix", "Holds elements at rest: in every way, or only in the ways that are named true.", "",
                      "sim:fix { beam.bottom, y = true }",
                      selecting<&Support::selection>(
                          {row<&Support::x>("x", optional, "along x"), row<&Support::y>("y", optional, "along y"),
                           row<&Support::rotation>("rotation", optional, "against turning")}));
    return made;
}

const WordOf<Motion>& move() {
    static const WordOf<Motion> made =
        word<Motion>("sim:move", "Prescribes how elements move; what is not named stays free.", "a load",
                     "local pull = sim:move { strip.top, velocity = { 0, 0.1 } }",
                     selecting<&Motion::selection>({
                         pair<&Motion::velocity_x, &Motion::velocity_y>("velocity", "m/s", "both components"),
                         row<&Motion::velocity_x>("velocity_x", "m/s", optional, any, "along x"),
                         row<&Motion::velocity_y>("velocity_y", "m/s", optional, any, "along y"),
                         pair<&Motion::displacement_x, &Motion::displacement_y>("displacement", "m", "both components"),
                         row<&Motion::displacement_x>("displacement_x", "m", optional, any,
                                                      "along x, from where the element stands when the motion begins"),
                         row<&Motion::displacement_y>("displacement_y", "m", optional, any, "along y"),
                         row<&Motion::spin>("spin", "rad/s", optional, any, "how fast each element turns"),
                     }));
    return made;
}

const WordOf<Force>& force() {
    static const WordOf<Force> made = word<Force>(
        "sim:force", "A force shared equally among elements.", "a load",
        "local push = sim:force { beam.top, y = dem.ramp { to = -1e3, over = 1e-3 } }",
        selecting<&Force::selection>({row<&Force::x>("x", "N", optional, any, "along x, sum over the elements"),
                                      row<&Force::y>("y", "N", optional, any, "along y, sum over the elements")}));
    return made;
}

const WordOf<Traction>& traction() {
    static const WordOf<Traction> made = word<Traction>(
        "sim:traction", "Stress on a side of a body.", "a load",
        R"(local pull = sim:traction { plate.top, stress_y = 2e6, rotation = "held" })",
        selecting<&Traction::selection>(
            {row<&Traction::stress_x>("stress_x", "Pa", optional, any, "force along x per area of the side"),
             row<&Traction::stress_y>("stress_y", "Pa", optional, any, "force along y per area of the side"),
             choice<&Traction::hold_rotation, rotation_names>("rotation", "of the loaded elements")}));
    return made;
}

const WordOf<RampSaid>& ramp() {
    static const WordOf<RampSaid> made = word<RampSaid>(
        "dem.ramp", "A value that changes evenly and then stays.", "a signal", "dem.ramp { to = 4e6, over = 50e-3 }",
        {row<&RampSaid::to>("to", "", required, any, "the value at the end"),
         row<&RampSaid::over>("over", "s", required, positive, "how long it takes"),
         row<&RampSaid::from>("from", "", optional, any, "the value at the start"),
         row<&RampSaid::start>("start", "s", optional, any, "when it starts; else at once")});
    return made;
}

const WordOf<Notch>& notch() {
    static const WordOf<Notch> made =
        word<Notch>("sim:notch", "A straight cut: bonds that cross it are broken before the run.", "",
                    "sim:notch { plate, from = { 0, 0.5 }, to = { 0.03, 0.5 } }",
                    {row<&Notch::body, BodySlot>("body", required, "which; the word itself may be left out").at(1),
                     row<&Notch::from>("from", "m", required, any, "one end"),
                     row<&Notch::to>("to", "m", required, any, "the other end")});
    return made;
}

const WordOf<Damping>& damping() {
    static const WordOf<Damping> made = word<Damping>(
        "sim:damping",
        "Rayleigh damping through one fraction of critical at one frequency (then of mass alone) or through two. "
        "The last one said counts.",
        "", "sim:damping { fraction = 0.5, frequency = 800 }",
        {
            row<&Damping::fraction>("fraction", "", required, non_negative, "of critical, at frequency"),
            row<&Damping::frequency>("frequency", "Hz", required, positive, "where fraction holds"),
            row<&Damping::second_fraction>("second_fraction", "", optional, non_negative,
                                           "of critical, at second_frequency"),
            row<&Damping::second_frequency>("second_frequency", "Hz", optional, positive,
                                            "where second_fraction holds"),
        });
    return made;
}

const WordOf<Probe>& probe() {
    static const WordOf<Probe> made =
        word<Probe>("sim:probe", "Writes the mean of a field (of forces and energies: the sum) to the history.", "",
                    R"(sim:probe { beam.bottom, name = "support", measure = "force_y" })",
                    selecting<&Probe::selection>({row<&Probe::name>("name", required, "of the column"),
                                                  row<&Probe::measure>("measure", required, "an element field")}));
    return made;
}

const WordOf<BondProbe>& bond_probe() {
    static const WordOf<BondProbe> made = word<BondProbe>(
        "sim:bond_probe",
        "Writes to the history what one bond bears and how far it has gone: NAME_normal, NAME_shear (forces, N; "
        "tension positive), NAME_stretch, NAME_slide (m), and where bonds can break NAME_cap_normal, NAME_cap_shear "
        "(the most it bears now, N; no column without a cap), NAME_damage (0 to 1) and NAME_state (0 elastic, 1 "
        "yielded, 2 broken).",
        "", R"(sim:bond_probe { plate, name = "tip", at = { 0.03, 0.5 } })",
        {row<&BondProbe::body, BodySlot>("body", required, "which; the word itself may be left out").at(1),
         row<&BondProbe::name>("name", required, "before the columns' names"),
         row<&BondProbe::at>("at", "m", optional, any, "the bond whose middle is nearest to this place"),
         row<&BondProbe::between>("between", optional,
                                  "the bond of these elements, numbered as the field id has them")});
    return made;
}

const WordOf<HistorySaid>& history() {
    static const WordOf<HistorySaid> made = word<HistorySaid>(
        "sim:history", "Adds columns to the history. What several calls ask adds up and stays in force for later runs.",
        "a history",
        R"(sim:history { every = 1e-5, speed = function(now) return now.body.shot.velocity.y end, stress = "stress_yy" })",
        {row<&HistorySaid::every>("every", "s", required, positive, "time between rows")},
        "a column: a function of `now` that returns a number, or the name of an element field, read over all elements");
    return made;
}

const WordOf<OutputSaid>& output() {
    static const WordOf<OutputSaid> made = word<OutputSaid>(
        "sim:output",
        "Asks for frames of elements and bonds. What several calls ask adds up and stays in force for later runs.",
        "an output", "local frames = sim:output { every = 1e-4 }",
        {row<&OutputSaid::every>("every", "s", required, positive, "time between frames")});
    return made;
}

const WordOf<EverySaid>& every() {
    static const WordOf<EverySaid> made = word<EverySaid>(
        "sim:every",
        "Calls a function between steps: it may read, change loads, velocities and outputs, write a frame, or stop "
        "the run. It stays in force for later runs.",
        "", R"(sim:every { 1e-3, function(now) if now.broken_bonds > 100 then now:stop("cracked") end end })",
        {row<&EverySaid::interval>("interval", "s", required, positive, "time between calls").at(1),
         row<&EverySaid::act>("act", required, "called with `now`").at(2)});
    return made;
}

const WordOf<BondBreakSaid>& on_bond_break() {
    static const WordOf<BondBreakSaid> made = word<BondBreakSaid>(
        "sim:on_bond_break",
        "Calls a function for each bond that breaks, at the end of the step in which it does: as in sim:every it may "
        "read, change and stop. It stays in force for later runs. Bonds that a notch cuts do not count.",
        "", R"(sim:on_bond_break { function(event, now) print(event.time, event.x, event.y, now.broken_bonds) end })",
        {row<&BondBreakSaid::act>("act", required, "called with the event and `now`").at(1)});
    return made;
}

const WordOf<RunSaid>& run() {
    static const WordOf<RunSaid> made = word<RunSaid>(
        "sim:run",
        "Runs the simulation on from where it stands. The lines after it see what came of it and may "
        "change the model before the next run.",
        "a report with the fields ending, reason and steps", "sim:run { duration = 6e-3 }",
        {row<&RunSaid::duration>("duration", "s", required, positive, "how long; with until_rest, at most"),
         row<&RunSaid::until_rest>("until_rest", optional,
                                   "end as soon as all is at rest: kinetic energy below a thousandth of what bonds and "
                                   "contacts store, and forces left on elements below a thousandth of those in "
                                   "contacts; the report's reason is then \"at rest\""),
         choice<&RunSaid::driver, driver_names>(
             "driver",
             R"("dynamic": steps of motion; "quasi-static": from rest to rest, as if the loads grew slowly, for bonded bodies without walls, rigid bodies or contacts; the run ends early, with the reason, where there is no rest beyond: the time is then that of the last rest)"),
         row<&RunSaid::runs_after>(
             "runs_after", "", optional, positive,
             "quasi-static: bonds broken one after another while the load grows by less than 1/2000 of the run, after "
             "which there is said to be no rest")});
    return made;
}

const WordOf<StaticSolve>& solve_static() {
    static const WordOf<StaticSolve> made = word<StaticSolve>(
        "sim:solve_static",
        "Moves the elements to rest under the forces, tractions, gravity and given displacements as they are now, by "
        "solving for it instead of marching there; given velocities count as supports. It is taken as one step, with a "
        "frame before and after. Only for bonds that do not yield there, and without walls, rigid bodies and contacts "
        "that press.",
        "a report with the fields solutions and residual", "sim:solve_static {}",
        {row<&StaticSolve::tolerance>("tolerance", "", optional, positive,
                                      "what may be left on free elements, as a share of loads and reactions"),
         row<&StaticSolve::max_iterations>("max_iterations", "", optional, positive,
                                           "linear systems that may be solved on the way"),
         row<&StaticSolve::linear>("linear", optional,
                                   "solve once, of first order in displacements from where the elements were bonded; "
                                   "forces are then out of balance by the square of the rotations")});
    return made;
}

const WordOf<Nothing>& param() {
    static const WordOf<Nothing> made = word<Nothing>(
        "dem.param", "Declares parameters that `--set name=value` can change; gives a table of their values.",
        "a table",
        R"(local p = dem.param { impact_speed = { 80, "m/s", help = "straight down" }, supports_on = true })", {},
        "a parameter: its default (number, text, true or false), or { default, unit, help = text }");
    return made;
}

const WordOf<Nothing>& result() {
    static const WordOf<Nothing> made = word<Nothing>("dem.result", "Publishes values with the run's summary.", "",
                                                      "dem.result { final_speed = sim.now.body.shot.velocity.y }", {},
                                                      "a result: a number, a text, true or false");
    return made;
}

} // namespace words

const std::vector<const Word*>& all_words() {
    static const std::vector<const Word*> words{&words::param(),
                                                &words::simulation(),
                                                &words::material(),
                                                &words::rectangle(),
                                                &words::disc(),
                                                &words::polygon(),
                                                &words::half_plane(),
                                                &words::translated(),
                                                &words::rotated(),
                                                &words::close_packed(),
                                                &words::consolidated(),
                                                &words::relaxed(),
                                                &words::disks(),
                                                &words::elastic(),
                                                &words::plateau(),
                                                &words::softening(),
                                                &words::brittle_tensile(),
                                                &words::brittle_toughness(),
                                                &words::cohesive(),
                                                &words::body(),
                                                &words::cluster(),
                                                &words::grains(),
                                                &words::set_velocity(),
                                                &words::fix(),
                                                &words::move(),
                                                &words::force(),
                                                &words::traction(),
                                                &words::ramp(),
                                                &words::sawtooth(),
                                                &words::wall(),
                                                &words::servo(),
                                                &words::wall_move(),
                                                &words::outline(),
                                                &words::outline_move(),
                                                &words::contact(),
                                                &words::notch(),
                                                &words::damping(),
                                                &words::probe(),
                                                &words::bond_probe(),
                                                &words::history(),
                                                &words::output(),
                                                &words::every(),
                                                &words::on_bond_break(),
                                                &words::run(),
                                                &words::solve_static(),
                                                &words::result(),
                                                &words::compare(),
                                                &words::study()};
    return words;
}

} // namespace demlua::model
