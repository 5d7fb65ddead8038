#include "engine/model/check_walls.hpp"

#include "engine/model/figure.hpp"
#include "engine/model/setting.hpp"

#include <algorithm>
#include <set>
#include <string>

namespace demlua::model {

namespace {

void check_path(const Wall& wall, Findings& findings) {
    if (wall.path.size() < 2) {
        findings.add(wall.place, "wall.path", "", "must have at least two points");
    }
    for (std::size_t k = 1; k < wall.path.size(); ++k) {
        if (!(wall.path[k] == wall.path[k - 1])) continue;
        findings.add(wall.place, "wall.path[" + std::to_string(k + 1) + "]", "",
                     "must differ from the point before it");
    }
    if (wall.path.size() == 3 && without_return(wall.path).size() == 2)
        findings.add(wall.place, "wall.path", "", "must have three points or more to be closed");
}

double extent_of(const std::vector<Vec2>& path, double Vec2::*axis) {
    const auto [least, most] =
        std::minmax_element(path.begin(), path.end(), [&](Vec2 a, Vec2 b) { return a.*axis < b.*axis; });
    return path.empty() ? 0.0 : (*most).*axis - (*least).*axis;
}

void check_servo(const Wall& wall, Findings& findings) {
    const Servo& servo = *wall.servo;
    if (!servo.along_x() && !servo.along_y()) {
        findings.add(wall.place, "wall.servo", "", "seeks nothing: give stress_x, stress_y, force_x or force_y");
    }
    if (servo.stress_x && servo.force_x) {
        findings.add(wall.place, "wall.servo.force_x", "", "must not be given beside stress_x");
    }
    if (servo.stress_y && servo.force_y) {
        findings.add(wall.place, "wall.servo.force_y", "", "must not be given beside stress_y");
    }
    if (servo.stress_x && extent_of(wall.path, &Vec2::y) == 0.0) {
        findings.add(wall.place, "wall.servo.stress_x", "", "needs a wall with a height", "give force_x");
    }
    if (servo.stress_y && extent_of(wall.path, &Vec2::x) == 0.0) {
        findings.add(wall.place, "wall.servo.stress_y", "", "needs a wall with a width", "give force_y");
    }
    check_signal(servo.stress_x, "wall.servo.stress_x", wall.place, findings);
    check_signal(servo.stress_y, "wall.servo.stress_y", wall.place, findings);
    check_signal(servo.force_x, "wall.servo.force_x", wall.place, findings);
    check_signal(servo.force_y, "wall.servo.force_y", wall.place, findings);
}

void check_wall(const Wall& wall, Findings& findings) {
    check_path(wall, findings);
    check_signal(wall.velocity_x, "wall.velocity_x", wall.place, findings);
    check_signal(wall.velocity_y, "wall.velocity_y", wall.place, findings);
    check_signal(wall.spin, "wall.spin", wall.place, findings);
    if (wall.servo) check_servo(wall, findings);
}

void check_outline(const Outline& outline, Findings& findings) {
    const std::string fault = outline_fault(outline);
    if (!fault.empty()) {
        findings.add(outline.place, outline.path.empty() ? "outline.region" : "outline.path", "", fault);
    }
    check_signal(outline.given_x, "outline.velocity_x", outline.place, findings);
    check_signal(outline.given_y, "outline.velocity_y", outline.place, findings);
    check_signal(outline.given_spin, "outline.spin", outline.place, findings);
}

struct Said {
    std::string name;
    Place place;
    std::string what;
};

} // namespace

void check_walls(const Scene& scene, Findings& findings) {
    for (const Wall& wall : scene.walls) check_wall(wall, findings);
    for (const Outline& outline : scene.outlines) check_outline(outline, findings);
    const bool meets_walls = !scene.walls.empty() || !scene.outlines.empty();
    if (meets_walls && scene.greatest_move > greatest_move_at_walls) {
        findings.add(scene.place, "simulation.greatest_move", text_of(scene.greatest_move),
                     "must be at most 0.5 in a scene with walls",
                     "elements that move farther in a step could pass a wall unseen");
    }
}

void check_wall_names(const Scene& scene, Findings& findings) {
    std::vector<Said> said;
    for (const Wall& wall : scene.walls) said.push_back({wall.name, wall.place, "wall.name"});
    for (const Outline& outline : scene.outlines) said.push_back({outline.name, outline.place, "outline.name"});
    std::set<std::string> names;
    for (const Said& each : said) {
        if (each.name.empty() || names.insert(each.name).second) continue;
        findings.add(each.place, each.what, '"' + each.name + '"', "is already the name of another wall or outline");
    }
}

} // namespace demlua::model
