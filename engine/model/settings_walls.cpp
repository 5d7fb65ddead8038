// Rows of walls, of servos that move them, and of rigid outlines.
#include "engine/model/rows.hpp"
#include "engine/model/settings.hpp"

namespace demlua::model::words {

using namespace rows;

const WordOf<SawtoothSaid>& sawtooth() {
    static const WordOf<SawtoothSaid> made = word<SawtoothSaid>(
        "dem.sawtooth", "The points of a rough line: teeth that rise to the left of the way from one end to the other.",
        "a list of points", "dem.sawtooth { from = { 0, 0 }, to = { 0.3, 0 }, height = 2e-3, pitch = 4e-3 }",
        {row<&SawtoothSaid::from>("from", "m", required, any, "one end"),
         row<&SawtoothSaid::to>("to", "m", required, any, "the other end"),
         row<&SawtoothSaid::height>("height", "m", required, positive, "of the teeth"),
         row<&SawtoothSaid::pitch>("pitch", "m", required, positive,
                                   "width of a tooth; the nearest that gives a whole number of teeth is taken")});
    return made;
}

const WordOf<Wall>& wall() {
    static const WordOf<Wall> made = word<Wall>(
        "sim:wall",
        "A rigid line of segments that elements meet from either side. What a wall does is read as floor.force or "
        "now.wall.NAME.force.",
        "a wall", R"(local floor = sim:wall { name = "floor", path = { { -1, 0 }, { 1, 0 } }, friction = 0.5 })",
        {
            row<&Wall::name>("name", required, "as results call it: now.wall.NAME"),
            row<&Wall::path>("path", "m", required, any,
                             "its points in order, at least two; closed where the last is the first"),
            row<&Wall::friction>("friction", "", optional, non_negative,
                                 "Coulomb coefficient; without it the element's counts"),
            pair<&Wall::velocity_x, &Wall::velocity_y>("velocity", "m/s", "how it moves; else it stands"),
            row<&Wall::velocity_x>("velocity_x", "m/s", optional, any, "along x"),
            row<&Wall::velocity_y>("velocity_y", "m/s", optional, any, "along y"),
            row<&Wall::spin>("spin", "rad/s", optional, any, "how fast it turns, counter-clockwise"),
            row<&Wall::centre>("centre", "m", optional, any,
                               "what it turns about, which moves with it; else the middle of its extent"),
            row<&Wall::servo>("servo", optional, "moves it so that it presses as asked, see wall.servo"),
        });
    return made;
}

const WordOf<Servo>& servo() {
    static const WordOf<Servo> made = word<Servo>(
        "wall.servo",
        "What sim:wall and wall:move take as servo: the wall moves along x, y or both so that it presses with a stress "
        "or a "
        "force; along the other axis it keeps its velocity. Positive presses on what the wall meets: the side on which "
        "the "
        "middle of all elements lies when the servo is said.",
        "", R"(sim:wall { name = "lid", path = { { 0, 1 }, { 1, 1 } }, servo = { stress_y = 100e3 } })",
        {
            row<&Servo::stress_x>(
                "stress_x", "Pa", optional, any,
                "over the wall's height times thickness, as it stands when this is said; where the wall "
                "stands out beyond what it presses on, say force_x"),
            row<&Servo::stress_y>("stress_y", "Pa", optional, any, "over its width times thickness, likewise"),
            row<&Servo::force_x>("force_x", "N", optional, any, "in place of stress_x"),
            row<&Servo::force_y>("force_y", "N", optional, any, "in place of stress_y"),
            row<&Servo::gain>("gain", "", optional, share,
                              "share of the missing force that a step makes up for while elements stand still; contact "
                              "dashpots make it slower"),
            row<&Servo::max_speed>("max_speed", "m/s", optional, positive,
                                   "else a tenth of sqrt(stress/density), with the mean density of the elements"),
            row<&Servo::travel>("travel", "m", optional, positive,
                                "how far it may go without meeting anything before the run stops; else as far as all "
                                "elements and walls reach along the axis"),
        });
    return made;
}

const WordOf<Wall>& wall_move() {
    static const WordOf<Wall> made =
        word<Wall>("wall:move", "Changes how a wall moves, from now on; what is not named stays as it was.", "",
                   "floor:move { velocity = { 0.05, 0 } }",
                   {pair<&Wall::velocity_x, &Wall::velocity_y>("velocity", "m/s", "both components"),
                    row<&Wall::velocity_x>("velocity_x", "m/s", optional, any, "along x"),
                    row<&Wall::velocity_y>("velocity_y", "m/s", optional, any, "along y"),
                    row<&Wall::spin>("spin", "rad/s", optional, any, "how fast it turns"),
                    row<&Wall::servo>("servo", optional, "in place of any it had"),
                    row<&Wall::stop>("stop", optional, "ends every motion and any servo before the rest is read")});
    return made;
}

const WordOf<Outline>& outline() {
    static const WordOf<Outline> made = word<Outline>(
        "sim:outline",
        "A rigid figure of any outline, with the mass, centre of mass and moment of inertia of its area. Elements meet "
        "its sides as they meet a wall's, with stiffness and damping in series with its material's; so do the corners "
        "of other outlines, and its own corners meet walls. It moves freely, under gravity and what presses on it, "
        "until outline:move says otherwise. What is moved in every way meets elements and free outlines only; where it "
        "comes across a wall or another such outline a warning says so, once. It is "
        "read like a wall: now.wall.NAME.",
        "an outline",
        R"(local shot = sim:outline { name = "shot", material = steel, region = dem.rectangle { size = { 0.2, 0.1 } }, velocity = { 0, -5 } })",
        {
            row<&Outline::name>("name", required, "as results call it: now.wall.NAME"),
            row<&Outline::material, MaterialSlot>("material", required, "what it is made of"),
            row<&Outline::path>("path", "m", optional, any, "its corners in order; or else region"),
            row<&Outline::region>("region", optional, "bounded by straight lines, in one piece and without holes"),
            row<&Outline::velocity>("velocity", "m/s", optional, any, "of its centre of mass at the start"),
            row<&Outline::spin>("spin", "rad/s", optional, any, "at the start"),
            row<&Outline::friction>(
                "friction", "", optional, non_negative,
                "Coulomb coefficient; the smallest of this, its material's and the element's counts"),
            row<&Outline::rounding>("rounding", "m", optional, positive,
                                    "radius of its corners where they meet walls and outlines, less where sides are "
                                    "short; else that of the smallest element"),
        });
    return made;
}

const WordOf<Outline>& outline_move() {
    static const WordOf<Outline> made = word<Outline>(
        "outline:move", "Gives an outline's motion from now on; what is not named stays as it was, given or free.", "",
        "platen:move { velocity = { 0, -0.1 }, spin = 0 }",
        {pair<&Outline::given_x, &Outline::given_y>("velocity", "m/s", "both components"),
         row<&Outline::given_x>("velocity_x", "m/s", optional, any, "along x"),
         row<&Outline::given_y>("velocity_y", "m/s", optional, any, "along y"),
         row<&Outline::given_spin>("spin", "rad/s", optional, any, "how fast it turns"),
         row<&Outline::let_go>("free", optional, "frees it in every way before the rest is read")});
    return made;
}

} // namespace demlua::model::words
