// Packs kept from run to run: what comes back is what went in, or nothing.
#include "engine/output/pack_folder.hpp"
#include "engine/packing/pack_store.hpp"
#include "tests/catch.hpp"
#include "tests/scene_language.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace {

namespace fs = std::filesystem;
using demlua::model::Consolidation;
using demlua::model::Region;
using demlua::model::Relaxation;
using demlua::output::PackFolder;
using demlua::packing::Packing;
using demlua::test::text_of;

/// A folder of this test alone, gone afterwards.
struct Scratch {
    fs::path path = "packs_" + std::to_string(getpid());

    Scratch() { fs::remove_all(path); }
    ~Scratch() { fs::remove_all(path); }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    Scratch(Scratch&&) = delete;
    Scratch& operator=(Scratch&&) = delete;
};

/// Packs through a store and counts how often it had to.
struct Counting {
    int made = 0;

    Packing pack(const PackFolder* store, const Region& region, const Consolidation& settings) {
        return demlua::packing::kept(store, region, settings, [this](const Region& in, const Consolidation& how) {
            ++made;
            return demlua::packing::consolidated(in, how);
        });
    }
};

void check_same(const Packing& a, const Packing& b) {
    CHECK(a.centre == b.centre);
    CHECK(a.radius == b.radius);
    CHECK(a.cluster == b.cluster);
    CHECK(a.cell_area == b.cell_area);
}

Consolidation few() {
    Consolidation settings;
    settings.count = 60;
    settings.solid_fraction = 0.75;
    return settings;
}

const Region plate = Region::rectangle({0.0, 0.0}, {1.0, 0.5}).without(Region::disc({0.4, 0.2}, 0.1));

std::size_t files_in(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

} // namespace

TEST_CASE("a kept pack is the same to the last bit and is made once", "[packs]") {
    const Scratch scratch;
    const PackFolder folder(scratch.path / "made" / "when needed");
    Counting counting;
    const Packing plain = counting.pack(nullptr, plate, few());
    check_same(counting.pack(&folder, plate, few()), plain);
    CHECK(counting.made == 2);
    check_same(counting.pack(&folder, plate, few()), plain);
    CHECK(counting.made == 2);
    CHECK(files_in(scratch.path / "made" / "when needed") == 1);
}

TEST_CASE("whatever a pack follows from tells it from others", "[packs]") {
    const auto settings = [](auto change) {
        Consolidation made = few();
        change(made);
        return demlua::packing::inputs_of(plate, made);
    };
    const auto same = demlua::packing::inputs_of(plate, few());
    CHECK(settings([](Consolidation&) {}) == same);
    CHECK_FALSE(settings([](Consolidation& s) { s.seed = 2; }) == same);
    CHECK_FALSE(settings([](Consolidation& s) { s.count = 61; }) == same);
    CHECK_FALSE(settings([](Consolidation& s) { s.cluster = 1; }) == same);
    CHECK_FALSE(settings([](Consolidation& s) { s.relax = 1; }) == same);
    CHECK_FALSE(settings([](Consolidation& s) { s.solid_fraction = 0.76; }) == same);
    CHECK_FALSE(settings([](Consolidation& s) { s.radius = 0.1; }) == same);
    CHECK_FALSE(demlua::packing::inputs_of(plate.translated({1e-15, 0.0}), few()) == same);
    Relaxation even;
    even.count = 60;
    const auto relaxed = demlua::packing::inputs_of(plate, even);
    CHECK(relaxed);
    even.on_boundary = true;
    CHECK_FALSE(demlua::packing::inputs_of(plate, even) == relaxed);
    even.size = [](demlua::Vec2 /*p*/) { return 0.1; };
    CHECK_FALSE(demlua::packing::inputs_of(plate, even)); // what a function says cannot be known beforehand
}

TEST_CASE("a damaged pack is made again, one of other inputs is not taken", "[packs]") {
    const Scratch scratch;
    const PackFolder folder(scratch.path);
    Counting counting;
    const Packing plain = counting.pack(&folder, plate, few());
    const std::string key = *demlua::packing::inputs_of(plate, few());
    const fs::path file = folder.file_of(key);
    const std::string whole = text_of(file);
    const auto write = [&file](const std::string& text) { std::ofstream(file, std::ios::binary) << text; };

    std::string flipped = whole;
    flipped[flipped.size() / 2] = static_cast<char>(flipped[flipped.size() / 2] ^ 1);
    for (const std::string& damaged : {flipped, whole.substr(0, whole.size() / 2), std::string(), whole + "x"}) {
        write(damaged);
        const int before = counting.made;
        check_same(counting.pack(&folder, plate, few()), plain);
        CHECK(counting.made == before + 1);
        CHECK(text_of(file) == whole);
    }

    // the file of one key under the name of another, as if their hashes were equal
    Consolidation other = few();
    other.seed = 2;
    const std::string other_key = *demlua::packing::inputs_of(plate, other);
    fs::copy_file(file, folder.file_of(other_key));
    CHECK_FALSE(folder.find(other_key));
    CHECK(folder.find(key));
}

TEST_CASE("nothing fails where packs cannot be kept", "[packs]") {
    const Scratch scratch;
    std::ofstream(scratch.path) << "a file where a folder should be";
    const PackFolder folder(scratch.path);
    Counting counting;
    const Packing plain = counting.pack(nullptr, plate, few());
    check_same(counting.pack(&folder, plate, few()), plain);
    check_same(counting.pack(&folder, plate, few()), plain);
    CHECK(counting.made == 3);
}

TEST_CASE("a folder of packs does not grow for ever", "[packs]") {
    const Scratch scratch;
    const PackFolder folder(scratch.path);
    for (int k = 0; k < 80; ++k) folder.keep(std::to_string(k), "pack");
    CHECK(files_in(scratch.path) == 64);
    CHECK(folder.find("79") == "pack");
}

TEST_CASE("a scene comes out the same with kept packs and without", "[packs]") {
    const Scratch scratch;
    const PackFolder folder(scratch.path);
    const demlua::model::Scene scene = demlua::test::checked(demlua::test::rock + R"(
local sim = dem.simulation {}
for k, packing in ipairs { dem.consolidated { count = 60, solid_fraction = 0.7 }, dem.relaxed { count = 50 } } do
  sim:body { name = "body" .. k, material = rock, region = dem.rectangle { at = { 2 * k, 0 }, size = { 1, 1 } },
             packing = packing, bonds = dem.elastic { search = 0.5 } }
end
sim:run { duration = 1 }
)")
                                           .scene;
    const demlua::observe::Simulation plain(scene, 1);
    const demlua::observe::Simulation first(scene, 1, &folder);
    const demlua::observe::Simulation again(scene, 1, &folder);
    CHECK(files_in(scratch.path) == 2);
    for (const auto* other : {&first, &again}) {
        CHECK(other->time_step() == plain.time_step());
        CHECK(other->bond_count() == plain.bond_count());
        CHECK(other->element_count() == plain.element_count());
    }
}
