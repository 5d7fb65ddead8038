#include "engine/state/wall_assembly.hpp"

#include "engine/model/figure.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace demlua::state {

namespace {

Box box_of(const std::vector<Vec2>& points) {
    Box box{points.front(), points.front()};
    for (const Vec2 p : points) {
        box.lower = {std::min(box.lower.x, p.x), std::min(box.lower.y, p.y)};
        box.upper = {std::max(box.upper.x, p.x), std::max(box.upper.y, p.y)};
    }
    return box;
}

Vec2 middle_of(const Box& box) { return 0.5 * (box.lower + box.upper); }

/// Elements as one: what a servo must know of what it meets.
struct Together {
    Vec2 middle;
    Box extent;           ///< walls included, m
    double density = 0.0; ///< kg/m^3
};

Together together(const State& state) {
    const Elements& elements = state.elements;
    std::vector<Vec2> places;
    double mass = 0.0;
    double area = 0.0;
    Together all;
    for (std::size_t k = 0; k < elements.size(); ++k) {
        places.push_back(elements.position(k));
        all.middle += places.back() / static_cast<double>(elements.size());
        mass += elements.mass(k);
        area += elements.cell_area[k];
    }
    for (const Wall& wall : state.walls) places.insert(places.end(), wall.points.begin(), wall.points.end());
    all.extent = box_of(places);
    all.density = mass / (area * state.thickness);
    return all;
}

/// Of a servo along one axis: `stress` or `force` of the scene, and what stands for each if not said.
struct Asked {
    const std::optional<Signal>& stress;
    const std::optional<Signal>& force;
    double face;   ///< what a stress acts on, m^2
    double travel; ///< m
};

std::optional<Servo> servo_of(const model::Servo& said, const Asked& asked, double density) {
    if (!asked.stress && !asked.force) return std::nullopt;
    Servo servo;
    servo.force = asked.force ? *asked.force : *asked.stress;
    if (asked.stress) {
        for (double& value : servo.force.values) value *= asked.face;
    }
    double greatest = 0.0;
    for (const double value : servo.force.values) greatest = std::max(greatest, std::fabs(value));
    servo.gain = said.gain;
    servo.max_speed = said.max_speed.value_or(0.1 * std::sqrt(greatest / (asked.face * density)));
    servo.travel = said.travel.value_or(asked.travel);
    return servo;
}

void set_servo(const model::Wall& said, const State& state, Wall& wall) {
    wall.servo_x.reset();
    wall.servo_y.reset();
    if (!said.servo) return;
    const Together all = together(state);
    const Vec2 size = box_of(wall.points).size();
    const Vec2 reach = all.extent.size();
    // A wall without width (height) is said by force, and its greatest speed is found as if it had its length.
    const double length = std::max(size.x, size.y);
    const auto face = [&](double extent) { return state.thickness * (extent > 0.0 ? extent : length); };
    const model::Servo& servo = *said.servo;
    wall.servo_x = servo_of(servo, {servo.stress_x, servo.force_x, face(size.y), reach.x}, all.density);
    wall.servo_y = servo_of(servo, {servo.stress_y, servo.force_y, face(size.x), reach.y}, all.density);
}

/// Towards the side on which the middle of all elements lies.
Vec2 side_of(const Wall& wall, const State& state) {
    const Vec2 towards = together(state).middle - middle_of(box_of(wall.points));
    return {towards.x < 0.0 ? -1.0 : 1.0, towards.y < 0.0 ? -1.0 : 1.0};
}

double farthest_from(Vec2 centre, const std::vector<Vec2>& points) {
    double farthest = 0.0;
    for (const Vec2 p : points) farthest = std::max(farthest, norm(p - centre));
    return farthest;
}

/// Whether a path ends one period from where it began.
bool goes_on(const std::vector<Vec2>& path, Period period) {
    constexpr double same_place = 1e-9; // of the period
    const Vec2 between = path.back() - path.front();
    const double off = std::max(std::fabs(std::fabs(between.x) - period.length), std::fabs(between.y));
    return period.repeats() && off <= same_place * period.length;
}

Wall wall_of(const model::Wall& said, const State& state) {
    Wall wall;
    wall.name = said.name;
    wall.path = model::without_return(said.path);
    wall.closed = wall.path.size() < said.path.size();
    wall.centre = said.centre.value_or(middle_of(box_of(wall.path)));
    for (const MaterialFacts& facts : state.materials) {
        wall.rules.push_back({facts.stiffness.normal, facts.stiffness.shear, std::min(facts.friction, said.friction),
                              facts.damping_fraction, facts.rolling_friction});
    }
    wall.seam = !wall.closed && goes_on(wall.path, state.period);
    return wall;
}

Wall outline_of(const model::Outline& said, const model::Scene& scene, const State& state) {
    Wall outline;
    outline.name = said.name;
    outline.path = model::corners_of(said);
    outline.closed = true;
    const model::Figure figure = model::figure_of(outline.path);
    const double density = scene.materials[said.material].density * scene.thickness;
    const double rounding =
        said.rounding.value_or(*std::min_element(state.elements.radius.begin(), state.elements.radius.end()));
    outline.matter = Matter{said.material, density * figure.area, density * figure.polar, said.friction,
                            corners_of_path(outline.path, rounding)};
    outline.centre = figure.centre;
    for (std::size_t row = 0; row < state.materials.size(); ++row) {
        outline.rules.push_back(state.contacts.rules[row * state.contacts.materials + said.material]);
        double& friction = outline.rules.back().mu;
        friction = std::min(friction, said.friction);
    }
    outline.velocity = said.velocity;
    outline.spin = said.spin;
    return outline;
}

} // namespace

void set_motion(const model::Wall& said, const State& state, Wall& wall) {
    const Signal still = Signal::constant(0.0);
    wall.velocity_x = said.velocity_x.value_or(still);
    wall.velocity_y = said.velocity_y.value_or(still);
    wall.turning = said.spin.value_or(still);
    wall.presses = side_of(wall, state);
    set_servo(said, state, wall);
}

void set_motion(const model::Outline& said, Wall& outline) {
    outline.velocity_x = said.given_x;
    outline.velocity_y = said.given_y;
    outline.turning = said.given_spin;
}

void lay_out_walls(const model::Scene& scene, State& state) {
    for (const model::Wall& said : scene.walls) state.walls.push_back(wall_of(said, state));
    for (const model::Outline& said : scene.outlines) state.walls.push_back(outline_of(said, scene, state));
    for (Wall& wall : state.walls) {
        wall.reach = farthest_from(wall.centre, wall.path);
        wall.place();
    }
    for (std::size_t row = 0; row < scene.walls.size(); ++row) {
        set_motion(scene.walls[row], state, state.walls[row]);
    }
    for (std::size_t row = 0; row < scene.outlines.size(); ++row) {
        Wall& outline = state.walls[scene.walls.size() + row];
        set_motion(scene.outlines[row], outline);
        outline.presses = side_of(outline, state);
    }
}

} // namespace demlua::state
