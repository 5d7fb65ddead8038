// What is written changes as a scene goes, and how things move does not.
#include "scripting/run_host.hpp"
#include "tests/catch.hpp"
#include "tests/scene_language.hpp"

#include <atomic>
#include <set>

using namespace demlua;
using namespace demlua::test;
using Catch::Approx;

namespace {

/// What a scene left in its folder.
struct Written {
    std::set<std::int64_t> frames; ///< us
    std::set<std::int64_t> rows;   ///< us
    std::uint64_t hash = 0;
    double time_step = 0.0;
};

std::int64_t microseconds(const std::string& seconds) { return std::llround(1e6 * std::stod(seconds)); }

std::set<std::int64_t> times_of_frames(const std::filesystem::path& folder) {
    std::set<std::int64_t> times;
    const std::string text = text_of(folder / "elements.pvd");
    const std::string key = "timestep=\"";
    for (std::size_t at = text.find(key); at != std::string::npos; at = text.find(key, at + 1)) {
        CHECK(times.insert(microseconds(text.substr(at + key.size()))).second);
    }
    return times;
}

std::set<std::int64_t> times_of_rows(const std::filesystem::path& folder) {
    std::set<std::int64_t> times;
    std::istringstream lines(text_of(folder / "history.csv"));
    std::string line;
    REQUIRE(std::getline(lines, line));
    REQUIRE(line.rfind("time", 0) == 0);
    while (std::getline(lines, line)) CHECK(times.insert(microseconds(line)).second);
    return times;
}

Written written_by(const std::string& text) {
    const SceneFile file(text);
    const std::filesystem::path folder = scene_name + ".out";
    Terminal terminal(true);
    const std::atomic<bool> interrupted{false};
    Written written;
    {
        RunHost host({output::RunFolder(folder, file.path(), true), scene_name, text, {}, 1, 0.0}, terminal,
                     interrupted);
        run_scene(file.path(), {}, host);
        written.hash = host.simulation()->hash();
        written.time_step = host.simulation()->time_step();
        CHECK(host.finish("").state == "finished");
    }
    written.frames = times_of_frames(folder);
    written.rows = times_of_rows(folder);
    std::filesystem::remove_all(folder);
    return written;
}

/// A bonded block that falls, with loads on it; its time step is fitted to the intervals.
const std::string falling = rock + R"(local sim = dem.simulation { gravity = { 0, -10 } }
local block = sim:body { name = "block", material = rock, region = dem.rectangle { size = { 1, 1 } },
                         packing = dem.close_packed { radius = 0.1 }, bonds = dem.elastic {}, velocity = { 1, 0 } }
sim:fix { block.bottom, y = true }
)";

using Times = std::set<std::int64_t>;

/// What is due within a step is written at its end.
Times whole_milliseconds(const Times& microseconds) {
    Times times;
    for (const std::int64_t time : microseconds) times.insert(time / 1000);
    return times;
}

} // namespace

TEST_CASE("a callback writes a frame of its instant, once", "[scene][output]") {
    const Written written = written_by(falling + R"(
sim:output { every = 10e-3 }
sim:every { 5e-3, function(now)
  if now.time > 12e-3 and now.time < 18e-3 then now:frame() now:frame() end
  if now.time < 1e-3 then now:frame() end
end }
sim:run { duration = 20e-3 }
)");
    CHECK(written.frames == Times{0, 10000, 15000, 20000});
    CHECK(written.rows == written.frames); // without sim:history there is a row for each frame
}

TEST_CASE("intervals change in a callback, at once", "[scene][output]") {
    const Written written = written_by(falling + R"(
local frames, rows = sim:output { every = 10e-3 }, sim:history { every = 20e-3, x = function(now) return block.position.x end }
local changed = false
sim:every { 5e-3, function(now)
  if changed or now.time < 14e-3 then return end
  frames:set { every = 2e-3 }
  rows:set { every = 10e-3 }
  changed = true
end }
sim:run { duration = 25e-3 }
)");
    CHECK(whole_milliseconds(written.frames) == Times{0, 10, 17, 19, 21, 23, 25});
    CHECK(written.rows == Times{0, 25000});
}

TEST_CASE("intervals change between runs; others stay as they are", "[scene][output]") {
    const Written written = written_by(falling + R"(
local frames = sim:output { every = 10e-3 }
sim:output { every = 20e-3 }
local rows = sim:history { every = 5e-3 }
rows:set { every = 15e-3 }
sim:run { duration = 20e-3 }
frames:set { every = 5e-3 }
sim:run { duration = 10e-3 }
frames:set { every = 1 }
sim:run { duration = 30e-3 }
)");
    CHECK(written.frames == Times{0, 10000, 20000, 25000, 30000, 50000, 60000});
    CHECK(written.rows == Times{0, 15000, 20000, 30000, 45000, 60000});
}

TEST_CASE("changing what is written changes neither step nor motion", "[scene][output]") {
    const std::string said =
        falling + "local frames, rows = sim:output { every = 7e-3 }, sim:history { every = 3e-3 }\n";
    const std::string runs = "sim:run { duration = 13e-3 } BETWEEN sim:run { duration = 17e-3 }\n";
    const auto with = [&](const std::string& before, const std::string& between) {
        std::string text = said + before + runs;
        return written_by(text.replace(text.find("BETWEEN"), 7, between));
    };
    const Written plain = with("", "");
    const Written changed = with(R"(
local calls = 0
sim:every { 3e-3, function(now)
  calls = calls + 1
  now:frame()
  frames:set { every = 1e-3 / calls }
  rows:set { every = 1e-9 }
end }
)",
                                 "frames:set { every = 0.3e-3 } rows:set { every = 11e-3 }");
    CHECK(changed.frames.size() > 2 * plain.frames.size());
    CHECK(changed.rows.size() > 2 * plain.rows.size());
    CHECK(changed.time_step == plain.time_step);
    CHECK(changed.hash == plain.hash);
}

TEST_CASE("wrong changes of what is written are told", "[scene][output]") {
    const auto told = [](const std::string& wrong) {
        BareHost host;
        auto messages = problems_of([&] {
            run(stone + "local frames, rows = sim:output { every = 0.5 }, sim:history { every = 0.5 }\n" + wrong, host);
        });
        REQUIRE(messages.size() == 1);
        return messages[0].substr(0, messages[0].find("\nstack traceback"));
    };
    const auto in_callback = [&](const std::string& wrong) {
        return told("sim:every { 1, function(now) " + wrong + " end } sim:run { duration = 1 }");
    };
    CHECK(told("frames:set { every = -1 }") == scene_name + ":6: output.every = -1: must be positive");
    CHECK(in_callback("rows:set { every = -1 }") == scene_name + ":6: history.every = -1: must be positive");
    CHECK(told("rows:set { every = 1, speed = \"speed\" }") ==
          scene_name + ":6: history.speed = \"speed\": unknown setting; known are every");
    CHECK(told("frames:sat { every = 1 }") ==
          scene_name + ":6: unknown field \"sat\" of output; did you mean \"set\"?");
    CHECK(told("sim:run { duration = 1 } sim.now:frame()") ==
          scene_name + ":6: now:frame is for functions called during a run");
    CHECK(in_callback("sim:output { every = 1 }") ==
          scene_name + ":6: sim:output cannot be called while a run is going on; call it before and change it with "
                       "output:set");
}
