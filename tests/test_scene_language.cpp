// The scene language: what right scenes come to, and what wrong ones are told.
#include "engine/model/settings.hpp"
#include "scripting/sample.hpp"
#include "tests/catch.hpp"
#include "tests/scene_language.hpp"

#include <algorithm>
#include <cmath>

using namespace demlua;
using namespace demlua::test;

TEST_CASE("a wrong scene is told every problem, each with its line", "[scene]") {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(source_folder / "tests/scenes/wrong")) {
        files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    CHECK(files.size() >= 60);
    for (const auto& file : files) {
        INFO(file.filename().string());
        std::vector<std::string> told = problems_of([&] { check_scene(file, {}); });
        for (std::string& message : told) message = message.substr(0, message.find("\nstack traceback"));
        CHECK(told == expected_problems(file));
    }
}

TEST_CASE("a scene that is not there, and a folder in its place", "[scene]") {
    CHECK(problems_of([] { check_scene("not_there.lua", {}); }) ==
          std::vector<std::string>{"not_there.lua: no such file"});
    CHECK(problems_of([] { check_scene(".", {}); }) == std::vector<std::string>{".: is a folder"});
}

TEST_CASE("compiled Lua is refused", "[scene]") {
    std::ofstream(scene_name) << "\x1bLua";
    const auto told = problems_of([] { check_scene(scene_name, {}); });
    std::filesystem::remove(scene_name);
    REQUIRE(told.size() == 1);
    CHECK_THAT(told[0], Catch::Matchers::ContainsSubstring("attempt to load a binary chunk"));
}

TEST_CASE("what a scene says arrives in the model", "[scene]") {
    const model::Scene scene = checked(R"(
local concrete = dem.material {
  name = "concrete", youngs_modulus = 30e9, poissons_ratio = 0.2, density = 2400, tensile_strength = 3e6,
  fracture_toughness = 1e6, rate_factor = 3, friction = 0.5, restitution = 0.4,
}
local sim = dem.simulation { title = "all", plane = "strain", thickness = 2, gravity = { 0, -9.81 }, time_step = "paper" }
local beam = sim:body {
  name = "beam", material = concrete, region = dem.rectangle { at = { 1, 2 }, size = { 3, 4 } }, velocity = { 5, 6 }, spin = 7,
  packing = dem.consolidated { cluster = 4, count = 120, seed = 9 }, bonds = dem.plateau { search = 0.2, break_in_shear = true },
}
sim:fix { beam.bottom, y = true, rotation = true }
sim:fix { beam, within = dem.disc { centre = { 1, 2 }, radius = 1 } }
sim:move { beam.top, velocity = { 1, { { 0, 0 }, { 1, 2 } } }, spin = 0 }
sim:force { { beam, where = function(x, y) return x > 2 end }, x = 4 }
sim:traction { beam.left, stress_x = dem.ramp { to = 8, over = 2 }, rotation = "held" }
local floor = sim:wall { name = "floor", path = { { 0, 0 }, { 1, 0 } }, velocity = { 0.5, 0 } }
floor:move { velocity_x = 0.25 }
sim:notch { beam, from = { 1, 3 }, to = { 2, 3 } }
sim:damping { fraction = 0.1, frequency = 50 }
sim:probe { beam.bottom, name = "support", measure = "force_y" }
)")
                                   .scene;
    CHECK(scene.title == "all");
    CHECK(scene.plane == model::Plane::strain);
    CHECK(scene.thickness == 2.0);
    CHECK(scene.gravity == Vec2{0.0, -9.81});
    CHECK(scene.time_step == model::StepRule::paper);
    REQUIRE(scene.materials.size() == 1);
    CHECK(scene.materials[0].rate_factor == 3.0);
    CHECK(scene.materials[0].restitution == 0.4);
    CHECK(scene.materials[0].place.line == 3);
    REQUIRE(scene.bodies.size() == 1);
    const model::Body& beam = scene.bodies[0];
    CHECK(beam.region.contains({1.5, 5.5}));
    CHECK(beam.velocity == Vec2{5.0, 6.0});
    CHECK(beam.spin == 7.0);
    CHECK(std::get<model::Consolidation>(beam.packing).cluster == 4);
    CHECK(std::get<model::Consolidation>(beam.packing).count == 120);
    CHECK(std::get<model::PlateauBonds>(beam.bonds).search == 0.2);
    CHECK(std::get<model::PlateauBonds>(beam.bonds).break_in_shear);
    REQUIRE(scene.supports.size() == 2);
    CHECK_FALSE(scene.supports[0].x);
    CHECK(scene.supports[0].y);
    CHECK(scene.supports[0].selection.side == model::Side::bottom);
    CHECK((scene.supports[1].x && scene.supports[1].y && scene.supports[1].rotation));
    CHECK(scene.supports[1].selection.within->contains({1.0, 2.5}));
    CHECK(scene.motions.at(0).velocity_y->at(0.5) == 1.0);
    CHECK_FALSE(scene.motions.at(0).displacement_x.has_value());
    CHECK(scene.forces.at(0).x.at(0.0) == 4.0);
    CHECK(scene.tractions.at(0).hold_rotation);
    CHECK(scene.tractions.at(0).stress_x.at(1.0) == 4.0);
    CHECK(scene.walls.at(0).velocity_x->at(0.0) == 0.25);
    CHECK(std::isinf(scene.walls.at(0).friction));
    CHECK(scene.notches.at(0).to == Vec2{2.0, 3.0});
    CHECK(scene.dampings.at(0).frequency == 50.0);
    CHECK(scene.probes.at(0).measure == "force_y");
}

TEST_CASE("grains and listed clusters reach the scene as said", "[scene]") {
    const model::Scene scene = checked(R"(
local sand = dem.material { youngs_modulus = 1e8, poissons_ratio = 0.2, density = 2650 }
local sim = dem.simulation {}
local box = dem.rectangle { size = { 1, 1 } }
local bent = dem.cluster { disks = { { 0, 0, 2 }, { 2, 0, 1 } }, rigid = true }
sim:grains { name = "a", material = sand, region = box, shape = bent, radius = { 0.01, 0.02 }, porosity = 0.3,
    removed = 0.1, velocity = { 1, 2 }, seed = 5 }
local classes = { { 0.01, 3 }, { radius = 0.02, share = 1 } }
sim:grains { name = "b", material = sand, region = box, radius = classes, method = "rain", count = 7 }
local three = dem.cluster { elements = 3, bonds = dem.elastic { search = 0.2 } }
sim:grains { name = "c", material = sand, region = box, shape = three, radius = 0.01, porosity = 0.2 }
local list = dem.disks { { 0, 0, 0.1, 5 }, { 1, 0, 0.1, 2 }, { x = 0.2, y = 0, radius = 0.1, cluster = 5 } }
sim:body { name = "d", material = sand, packing = list, rigid = true, in_clusters = true }
)")
                                   .scene;
    REQUIRE(scene.bodies.size() == 4);
    const auto grains = [&](std::size_t row) { return std::get<model::GrainPacking>(scene.bodies[row].packing); };
    CHECK(scene.bodies[0].rigid);
    CHECK(scene.bodies[0].in_clusters);
    CHECK(scene.bodies[0].velocity == Vec2{1.0, 2.0});
    CHECK(grains(0).disks.at(1).radius == 1.0);
    CHECK(grains(0).sizes.at(0).greatest == 0.02);
    CHECK(grains(0).porosity == 0.3);
    CHECK(grains(0).removed == 0.1);
    CHECK(grains(0).seed == 5);
    CHECK_FALSE(scene.bodies[1].rigid);
    CHECK(std::holds_alternative<model::NoBonds>(scene.bodies[1].bonds));
    CHECK(grains(1).elements == 1);
    CHECK(grains(1).method == model::Placing::rain);
    CHECK(grains(1).count == 7);
    CHECK(grains(1).sizes.at(0).share == 3.0);
    CHECK(grains(1).sizes.at(1).least == 0.02);
    CHECK(std::get<model::ElasticBonds>(scene.bodies[2].bonds).search == 0.2);
    CHECK(model::network_of(scene.bodies[2]) == model::Network::contacts);
    CHECK(grains(2).elements == 3);
    CHECK(std::get<model::ListedDisks>(scene.bodies[3].packing).clusters == std::vector<std::uint32_t>{0, 1, 0});
}

TEST_CASE("a function of place chooses where it says", "[scene]") {
    // The state must outlive the reading, since selections are asked when the scene is assembled.
    const SceneSummary summary = checked(block + "sim:fix { block, where = function(x, y) return x + y < 1 end }\n");
    const auto& where = summary.scene.supports.at(0).selection.where;
    CHECK(where({0.2, 0.7}));
    CHECK_FALSE(where({0.2, 0.9}));
}

TEST_CASE("parameters keep their type and are set from outside", "[scene]") {
    const std::string text = rock + R"(
local p = dem.param { speed = { 80, "m/s", help = "straight down" }, count = 12, fast = true, name = "shot" }
local sim = dem.simulation { title = p.name .. p.count }
sim:body { name = p.name, material = rock, packing = dem.disks { { 0, 0, 1 } }, velocity = { 0, -p.speed } }
)";
    const SceneSummary plain = checked(text);
    CHECK(plain.scene.title == "shot12");
    CHECK(plain.scene.bodies[0].velocity.y == -80.0);
    const SceneSummary set = checked(text, {{"speed", "1e2"}, {"fast", "false"}, {"name", "slug"}});
    CHECK(set.scene.title == "slug12");
    CHECK(set.scene.bodies[0].velocity.y == -100.0);
    REQUIRE(set.parameters.size() == 4);
    const Parameter& speed = set.parameters.back();
    CHECK(speed.name == "speed");
    CHECK(std::get<double>(speed.fallback) == 80.0);
    CHECK(speed.unit == "m/s");
    CHECK(speed.help == "straight down");
    CHECK(problems_of([&] {
              checked(text, {{"sped", "1"}, {"speed", "fast"}, {"fast", "1"}});
          }) == std::vector<std::string>{"--set fast = 1: must be true or false",
                                         "--set speed = fast: must be a number in m/s",
                                         "--set sped = 1: no such parameter in this scene; did you mean \"speed\"?"});
}

TEST_CASE("a scene includes another with other parameters", "[scene]") {
    const std::string file = (source_folder / "tests/scenes/right/plain.lua").string();
    const SceneSummary summary = checked("dem.include \"" + file + "\" { duration = 3 }", {{"radius", "0.2"}});
    REQUIRE(summary.runs.size() == 1);
    CHECK(summary.runs[0].duration == 3.0);
    CHECK(std::get<model::ClosePacking>(summary.scene.bodies[0].packing).radius == 0.2);
    CHECK(std::get<double>(summary.parameters[0].fallback) == 3.0);
}

TEST_CASE("an included file gives what it returns", "[scene]") {
    const std::string file = (source_folder / "scenarios/shared/handbook.lua").string();
    const SceneSummary summary = checked("local handbook = dem.include \"" + file + R"(" {}
local p = dem.param { whole = { handbook.transition_length(2, 1) * math.pi } }
local sim = dem.simulation {}
)");
    CHECK(std::get<double>(summary.parameters[0].fallback) == Catch::Approx(4.0));
}

TEST_CASE("runs are recorded as they are asked for", "[scene]") {
    const SceneSummary summary = checked(stone + R"(
sim:output { every = 0.5 }
sim:history { every = 0.1, height = function(now) return now.body.stone.position.y end, speed = "speed" }
sim:run { duration = 1 }
sim:output { every = 0.25 }
sim:every { 0.2, function(now) error("not called when only read") end }
sim:fix { stone }
sim:run { duration = 2 }
)");
    CHECK(summary.scene.supports.empty()); // as it stood at the first run
    REQUIRE(summary.runs.size() == 2);
    REQUIRE(summary.runs[0].frames.size() == 1);
    REQUIRE(summary.runs[1].frames.size() == 2);
    CHECK(summary.runs[0].frames[0]->said() == 0.5);
    CHECK(summary.runs[1].frames[1]->said() == 0.25);
    CHECK(summary.runs[1].duration == 2.0);
    REQUIRE(summary.runs[0].histories.size() == 1);
    CHECK(summary.runs[0].histories[0].columns[0].first == "height");
    CHECK(summary.runs[0].histories[0].columns[1].first == "speed");
    CHECK(summary.runs[0].callbacks.empty());
    CHECK(summary.runs[1].callbacks.size() == 1);
}

TEST_CASE("functions of time become signals", "[scene]") {
    const SceneSummary summary = checked(
        block + "sim:force { block.top, y = function(t) return 3 * math.sin(t) end }\nsim:run { duration = 10 }\n");
    const Signal& signal = summary.scene.forces.at(0).y;
    CHECK(signal.times.front() == 0.0);
    CHECK(signal.times.back() == 10.0);
    double worst = 0.0;
    for (double t = 0.0; t < 10.0; t += 1e-3) worst = std::max(worst, std::abs(signal.at(t) - 3.0 * std::sin(t)));
    CHECK(worst < 1e-5);
}

TEST_CASE("sampling spends its samples where they are needed", "[scene]") {
    const auto line = sample([](double t) { return 2.0 * t; }, 0.0, 1.0);
    CHECK(line.signal.times.size() == 2);
    const auto jump = sample([](double t) { return t < 1.0 / 3.0 ? 0.0 : 1.0; }, 0.0, 1.0);
    CHECK(jump.signal.times.size() < 20);
    CHECK(jump.signal.at(1.0 / 3.0 - 1e-8) == 0.0);
    CHECK(jump.signal.at(1.0 / 3.0 + 1e-8) == 1.0);
    const auto wild = sample([](double t) { return std::sin(1e6 * t); }, 0.0, 1.0);
    CHECK(wild.signal.times.size() <= greatest_sample_count);
    CHECK(wild.error > 1e-3);
}

TEST_CASE("the scenarios are right scenes", "[scene]") {
    for (const auto& entry : std::filesystem::directory_iterator(source_folder / "scenarios")) {
        if (entry.path().extension() != ".lua") continue;
        INFO(entry.path().string());
        CHECK_NOTHROW(check_scene(entry.path(), {}));
    }
    const SceneSummary slow = check_scene(source_folder / "scenarios/penetration_slow.lua", {});
    CHECK(slow.runs.at(0).duration == 15e-3);
    CHECK(slow.scene.bodies.at(1).velocity.y == -20.0);
}

TEST_CASE("every word explains itself, and the manual in docs is what the words say", "[scene]") {
    for (const model::Word* word : model::all_words()) {
        INFO(word->call);
        CHECK_FALSE(word->meaning.empty());
        CHECK_FALSE(word->example.empty());
        CHECK_THAT(words_as_text(word->name()), Catch::Matchers::ContainsSubstring(word->call));
        const std::string function = "function " + word->call + "(";
        const bool is_table = word->call == "wall.servo"; // said within another word's table
        CHECK_THAT(words_as_editor_stub(),
                   Catch::Matchers::ContainsSubstring(is_table ? "dem.wall_servo_settings" : function));
    }
    CHECK_THAT(words_as_text("elastic"), Catch::Matchers::ContainsSubstring("search [0.1]"));
    CHECK(words_as_text("elastc") == "unknown word \"elastc\"; did you mean \"elastic\"?\n");
    CHECK(words_as_markdown() == text_of(source_folder / "docs/scene.md"));
}
