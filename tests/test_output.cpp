// What a run leaves in its folder: whole files, truthful indexes, and nothing of another run.
#include "tests/catch.hpp"

#include "engine/base/problems.hpp"
#include "engine/observe/simulation.hpp"
#include "engine/output/history.hpp"
#include "engine/output/run_folder.hpp"
#include "engine/output/series.hpp"
#include "engine/output/summary.hpp"
#include "engine/output/vtu.hpp"
#include "engine/output/whole_file.hpp"
#include "engine/output/writer.hpp"

#include <nlohmann/json.hpp>

#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>
#include <string>

using namespace demlua;
using Catch::Matchers::ContainsSubstring;
namespace fs = std::filesystem;

namespace {

/// A folder of this process alone, gone with the test.
class Scratch {
public:
    Scratch() : path_(fs::temp_directory_path() / ("demlua-output-" + std::to_string(getpid()))) {
        fs::remove_all(path_);
        fs::create_directories(path_);
    }
    ~Scratch() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    Scratch(Scratch&&) = delete;
    Scratch& operator=(Scratch&&) = delete;

    [[nodiscard]] fs::path operator/(const std::string& name) const { return path_ / name; }

private:
    fs::path path_;
};

std::string text_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::set<std::string> names_in(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
    return names;
}

observe::Snapshot three_elements(double time, bool bonded = true) {
    observe::Snapshot snapshot;
    snapshot.time = time;
    snapshot.position = {{0.0, 0.0}, {1.0, 0.0}, {0.0, 2.0}};
    snapshot.element_fields = {{"id", "", 1, std::vector<std::int32_t>{0, 1, 2}},
                               {"velocity", "m/s", 2, std::vector<double>{1, 2, 3, 4, 5, 6}},
                               {"stress", "Pa", 3, std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9}}};
    if (bonded) {
        snapshot.bond_ends = {{0, 1}, {0, 2}};
        snapshot.bond_fields = {{"state", "", 1, std::vector<std::int32_t>{0, 2}}};
    }
    return snapshot;
}

std::string refusal(const output::RunFolder& folder) {
    try {
        folder.check();
    } catch (const SceneError& error) {
        return error.what();
    }
    return "accepted";
}

} // namespace

TEST_CASE("a frame's text is compressed appended binary with all its fields", "[output]") {
    const std::string elements = output::elements_vtu(three_elements(0.25));
    CHECK_THAT(elements, ContainsSubstring("NumberOfPoints=\"3\"") && ContainsSubstring("NumberOfCells=\"3\""));
    CHECK_THAT(elements, ContainsSubstring("compressor=") && ContainsSubstring("encoding=\"raw\""));
    CHECK_THAT(elements, ContainsSubstring("Name=\"TimeValue\"") && ContainsSubstring("Name=\"id\""));
    CHECK_THAT(elements, ContainsSubstring("Name=\"velocity\" NumberOfComponents=\"3\" ComponentName0=\"x\""));
    CHECK_THAT(elements, ContainsSubstring("Name=\"stress\" NumberOfComponents=\"3\" ComponentName0=\"xx\""));
    const std::string bonds = output::bonds_vtu(three_elements(0.25));
    CHECK_THAT(bonds, ContainsSubstring("NumberOfCells=\"2\"") && ContainsSubstring("Name=\"state\""));
}

TEST_CASE("cracks are lines with points of their own, and none are a file too", "[output]") {
    auto snapshot = three_elements(0.25);
    snapshot.crack_fields = {{"time", "s", 1, std::vector<double>{}}, {"mode", "", 1, std::vector<std::int32_t>{}}};
    const std::string none = output::cracks_vtu(snapshot);
    CHECK_THAT(none, ContainsSubstring("NumberOfPoints=\"0\"") && ContainsSubstring("NumberOfCells=\"0\""));
    CHECK_THAT(none, ContainsSubstring("Name=\"time\"") && ContainsSubstring("Name=\"mode\""));
    snapshot.crack_ends = {{Vec2{0.0, 0.0}, Vec2{0.0, 1.0}}, {Vec2{0.0, 1.0}, Vec2{1.0, 1.0}}};
    snapshot.crack_fields = {{"time", "s", 1, std::vector<double>{0.1, 0.2}}};
    const std::string two = output::cracks_vtu(snapshot);
    CHECK_THAT(two, ContainsSubstring("NumberOfPoints=\"4\"") && ContainsSubstring("NumberOfCells=\"2\""));
}

TEST_CASE("walls are lines through points of their own, with names", "[output]") {
    auto snapshot = three_elements(0.25);
    snapshot.wall_names = {"floor", "lid"};
    snapshot.wall_paths = {{{0.0, 0.0}, {1.0, 0.0}, {2.0, 1.0}}, {{0.0, 2.0}, {1.0, 2.0}}};
    snapshot.wall_fields = {{"force", "N", 2, std::vector<double>{0.0, 1.0, 2.0, 3.0}}};
    const std::string walls = output::walls_vtu(snapshot);
    CHECK_THAT(walls, ContainsSubstring("NumberOfPoints=\"5\"") && ContainsSubstring("NumberOfCells=\"2\""));
    CHECK_THAT(walls, ContainsSubstring("Name=\"name\"") && ContainsSubstring("Name=\"force\""));
}

TEST_CASE("a field that does not fit its rows is refused by name", "[output]") {
    auto snapshot = three_elements(0.0);
    snapshot.element_fields.push_back({"spin", "rad/s", 1, std::vector<double>{1.0}});
    CHECK_THROWS_WITH(output::elements_vtu(snapshot), "field spin has 1 numbers for 3 rows");
}

TEST_CASE("both indexes name every frame of a series with its time", "[output]") {
    const Scratch scratch;
    output::Series series(scratch / "", "elements");
    series.add(0.0, "first");
    series.add(0.1, "second");
    CHECK(names_in(scratch / "") ==
          std::set<std::string>{"elements_000000.vtu", "elements_000001.vtu", "elements.pvd", "elements.vtu.series"});
    CHECK(text_of(scratch / "elements_000001.vtu") == "second");
    CHECK_THAT(text_of(scratch / "elements.pvd"),
               ContainsSubstring("timestep=\"0\" group=\"\" part=\"0\" file=\"elements_000000.vtu\"") &&
                   ContainsSubstring("timestep=\"0.1\" group=\"\" part=\"0\" file=\"elements_000001.vtu\""));
    const auto json = nlohmann::json::parse(text_of(scratch / "elements.vtu.series"));
    CHECK(json["file-series-version"] == "1.0");
    REQUIRE(json["files"].size() == 2);
    CHECK(json["files"][1]["name"] == "elements_000001.vtu");
    CHECK(json["files"][1]["time"] == 0.1);
}

TEST_CASE("a file that cannot be written is named with the reason", "[output]") {
    const Scratch scratch;
    CHECK_THROWS_WITH(output::replace_file(scratch / "no/such.txt", "x"),
                      ContainsSubstring("such.txt cannot be written: No such file or directory"));
}

TEST_CASE("history numbers read back as they were", "[output]") {
    const Scratch scratch;
    output::HistoryFile history(scratch / "history.csv");
    history.add({{"time", 0.1}, {"a,b", 1.0 / 3.0}});
    CHECK(text_of(scratch / "history.csv") == "time,\"a,b\"\n0.1,0.3333333333333333\n");
    history.add({{"time", 1e-5}, {"a,b", -3.0}});
    CHECK_THAT(text_of(scratch / "history.csv"), ContainsSubstring("\n1e-05,-3\n"));
}

TEST_CASE("a history column that comes later is empty above, one that goes is empty below", "[output]") {
    const Scratch scratch;
    output::HistoryFile history(scratch / "history.csv");
    history.add({{"time", 0.1}, {"a,b", 2.0}, {"error", 3.0}});
    history.add({{"time", 0.2}, {"a,b", 2.5}, {"work", 7.0}, {"error", 4.0}});
    history.add({{"time", 0.3}, {"work", 8.0}, {"error", 5.0}});
    CHECK(text_of(scratch / "history.csv") == "time,\"a,b\",work,error\n0.1,2,,3\n0.2,2.5,7,4\n0.3,,8,5\n");
}

TEST_CASE("two history columns of one name are refused", "[output]") {
    const Scratch scratch;
    output::HistoryFile history(scratch / "history.csv");
    CHECK_THROWS_WITH(history.add({{"time", 0.0}, {"time", 1.0}}), "history: two columns are called time");
}

TEST_CASE("a run's folder is made when it opens and not before", "[output]") {
    const Scratch scratch;
    const output::RunFolder folder(scratch / "a/run.out", scratch / "x.lua", false);
    folder.check();
    CHECK_FALSE(fs::exists(scratch / "a"));
    folder.open("-- the scene");
    CHECK(names_in(scratch / "a/run.out") == std::set<std::string>{"scene.lua"});
    CHECK(text_of(scratch / "a/run.out/scene.lua") == "-- the scene");
}

TEST_CASE("another run's folder is refused, or emptied of that run alone", "[output]") {
    const Scratch scratch;
    fs::create_directory(scratch / "run");
    for (const char* name :
         {"run/summary.json", "run/elements_000123.vtu", "run/elements.pvd.unfinished", "run/bonds.vtu.series",
          "run/cracks_000001.vtu", "run/walls_000001.vtu", "run/notes.txt", "run/elements_of_style.vtu"}) {
        output::replace_file(scratch / name, "old");
    }
    const output::RunFolder careful(scratch / "run", scratch / "x.lua", false);
    CHECK_THAT(refusal(careful), ContainsSubstring("holds another run") && ContainsSubstring("--overwrite"));
    CHECK(names_in(scratch / "run").size() == 8);
    output::RunFolder(scratch / "run", scratch / "x.lua", true).open("new");
    CHECK(names_in(scratch / "run") == std::set<std::string>{"scene.lua", "notes.txt", "elements_of_style.vtu"});
}

TEST_CASE("files that no run wrote are never replaced", "[output]") {
    const Scratch scratch;
    output::replace_file(scratch / "scene.lua", "mine");
    const output::RunFolder other(scratch / "", scratch / "x.lua", true);
    CHECK_THAT(refusal(other), ContainsSubstring("holds scene.lua, which no run wrote"));
    output::replace_file(scratch / "summary.json", "{}");
    const output::RunFolder own(scratch / "", scratch / "scene.lua", true);
    CHECK_THAT(refusal(own), ContainsSubstring("must not be the folder of the scene itself"));
}

TEST_CASE("a place where nothing can be written is refused", "[output]") {
    const Scratch scratch;
    output::replace_file(scratch / "file", "x");
    CHECK_THAT(refusal(output::RunFolder(scratch / "file", "x.lua", false)), ContainsSubstring("is not a folder"));
    CHECK_THAT(refusal(output::RunFolder(scratch / "file/below", "x.lua", false)),
               ContainsSubstring("is not a folder"));
    if (geteuid() == 0) return; // nothing is closed to root
    fs::create_directory(scratch / "closed");
    fs::permissions(scratch / "closed", fs::perms::owner_read | fs::perms::owner_exec);
    CHECK_THAT(refusal(output::RunFolder(scratch / "closed/run", "x.lua", false)),
               ContainsSubstring("is not writable: Permission denied"));
}

TEST_CASE("the writer writes in the order given", "[output]") {
    const Scratch scratch;
    const output::RunFolder folder(scratch / "run", "x.lua", false);
    folder.open("");
    output::Writer writer(folder);
    writer.log(std::chrono::system_clock::now(), "begin");
    for (int k = 0; k < 20; ++k) {
        writer.frame(three_elements(0.5 * k));
        writer.history({{"time", 0.5 * k}});
    }
    writer.drain();
    CHECK(writer.frames() == 20);
    CHECK(writer.has_bonds());
    writer.finish("{}\n");
    CHECK_THAT(text_of(scratch / "run/run.log"), ContainsSubstring("  begin\n"));
    CHECK_THAT(text_of(scratch / "run/history.csv"), ContainsSubstring("time\n0\n0.5\n1\n"));
    CHECK_THAT(text_of(scratch / "run/bonds.pvd"), ContainsSubstring("timestep=\"9.5\""));
    CHECK(names_in(scratch / "run").size() == 20 * 2 + 4 + 4);
}

TEST_CASE("no bonds, no series of bonds", "[output]") {
    const Scratch scratch;
    const output::RunFolder folder(scratch / "run", "x.lua", false);
    folder.open("");
    output::Writer writer(folder);
    writer.frame(three_elements(0.0, false));
    writer.drain();
    CHECK_FALSE(writer.has_bonds());
    CHECK_FALSE(writer.has_cracks());
    CHECK_FALSE(fs::exists(scratch / "run/bonds.pvd"));
}

TEST_CASE("a folder that vanishes stops the run with one error", "[output]") {
    const Scratch scratch;
    const output::RunFolder folder(scratch / "run", "x.lua", false);
    folder.open("");
    output::Writer writer(folder);
    writer.frame(three_elements(0.0));
    writer.drain();
    fs::remove_all(scratch / "run");
    writer.frame(three_elements(0.5));
    CHECK_THROWS_AS(writer.drain(), RunError);
    CHECK_THROWS_WITH(writer.frame(three_elements(1.0)), ContainsSubstring("elements_000001.vtu cannot be written"));
    CHECK_THROWS_AS(writer.finish("{}"), RunError);
}

TEST_CASE("the summary holds inputs, ending, figures and versions", "[output]") {
    model::Scene scene;
    scene.title = "Two disks";
    model::Material steel;
    steel.name = "steel";
    steel.youngs_modulus = 200e9;
    steel.poissons_ratio = 0.3;
    steel.density = 7850.0;
    scene.materials = {steel};
    model::Body pair;
    pair.name = "pair";
    pair.packing = model::ListedDisks{{{{0.0, 0.0}, 0.01}, {{0.02, 0.0}, 0.01}}};
    pair.bonds = model::ElasticBonds{};
    scene.bodies = {pair};
    const observe::Simulation simulation(scene, 1);

    output::Summary summary;
    summary.scene_file = "two.lua";
    summary.inputs = output::inputs_json(scene, simulation);
    summary.ending = {"stopped", "enough \"seen\""};
    summary.parameters = {{"speed", 80.0, 70.0, "m/s", ""}, {"mode", std::string("slow"), std::string("fast"), "", ""}};
    summary.results = {{"force", 2.5}, {"held", true}};
    summary.figures = {{"time", 0.5}, {"depth", std::numeric_limits<double>::quiet_NaN()}};
    const auto json = nlohmann::json::parse(output::summary_json(summary, simulation));

    CHECK(json["ending"]["state"] == "stopped");
    CHECK(json["ending"]["reason"] == "enough \"seen\"");
    CHECK(json["inputs"]["title"] == "Two disks");
    CHECK(json["inputs"]["materials"][0]["youngs_modulus"] == 200e9);
    CHECK(json["inputs"]["materials"][0].count("tensile_strength") == 0);
    CHECK(json["inputs"]["bodies"][0]["elements"] == 2);
    CHECK(json["inputs"]["bodies"][0]["bonds"]["law"] == "elastic");
    CHECK(json["parameters"]["speed"]["value"] == 80.0);
    CHECK(json["parameters"]["mode"]["fallback"] == "fast");
    CHECK(json["results"]["held"] == true);
    CHECK(json["figures"]["depth"].is_null());
    CHECK(json["time_step"]["seconds"].get<double>() > 0.0);
    CHECK(json["hash"].get<std::string>().size() == 16);
    for (const char* name : {"demlua", "revision", "compiler", "build_type", "vtk"}) {
        CHECK(json["versions"][name].is_string());
    }
}
