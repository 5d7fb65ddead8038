// Measures one work and prints what it found as JSON: SI units, raw columns, one entry per round. With --exchange it follows
// the work over a fixed number of steps, as other programs are asked to. tools/bench reads what it prints.
#include "engine/output/pack_folder.hpp"
#include "tools/benchmark/exchange.hpp"
#include "tools/benchmark/measure.hpp"

#include "demlua/version.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace {

using namespace demlua;
using Json = nlohmann::ordered_json;

Json json_of(const bench::Rounds& rounds) {
    return {{"threads", rounds.threads},
            {"widest", rounds.widest},
            {"one_lane", rounds.one_lane},
            {"bytes_per_second", rounds.bytes},
            {"multiply_adds_per_second", rounds.multiply_adds},
            {"divisions_per_second", rounds.divisions}};
}

Json json_of(const bench::Work& work, const bench::Measurement& found) {
    Json json{{"work", work.name},          {"what", work.what},
              {"elements", found.elements}, {"bonds", found.bonds},
              {"touching", found.touching}, {"broken", found.broken},
              {"lanes", found.lanes},       {"bytes_per_element", found.bytes_per_element}};
    json["set_up"] = {{"assembly", found.set_up.assembly},
                      {"time_step", found.set_up.time_step},
                      {"first_forces", found.set_up.first_forces}};
    json["cost"] = {{"bytes", found.cost.bytes},
                    {"footprint", found.cost.footprint},
                    {"operations", found.cost.operations},
                    {"divisions", found.cost.divisions}};
    json["versions"] = {
        {"demlua", version}, {"revision", revision}, {"compiler", compiler}, {"build_type", build_type}};
    for (const bench::Rounds& rounds : found.rounds) json["rounds"].push_back(json_of(rounds));
    return json;
}

int run(int argc, char** argv) {
    CLI::App app("measures one work of tools/bench");
    std::string name;
    std::string packs;
    std::vector<int> threads{1};
    double seconds = 5.0;
    std::string exchange;
    bool list = false;
    app.add_option("work", name, "what to measure");
    app.add_option("--threads", threads, "thread counts, e.g. 1,2")->delimiter(',')->check(CLI::Range(1, 1024));
    app.add_option("--seconds", seconds, "to spend on steps")->check(CLI::PositiveNumber);
    app.add_option("--packs", packs, "folder where irregular packs are kept");
    app.add_option("--exchange", exchange, "file for the first instant, as other programs need it; \"-\" for none");
    app.add_flag("--list", list, "names the works");
    CLI11_PARSE(app, argc, argv);
    if (list) {
        for (const std::string& each : bench::names_of_works()) fmt::print("{}\n", each);
        return 0;
    }
    const output::PackFolder folder(packs);
    const bench::Work work = bench::work_of(name);
    if (!exchange.empty()) {
        fmt::print("{}\n", bench::follow(work, threads.front(), packs.empty() ? nullptr : &folder, exchange).dump());
        return 0;
    }
    fmt::print("{}\n", json_of(work, bench::measure(work, threads, seconds, packs.empty() ? nullptr : &folder)).dump());
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& fault) {
        fmt::print(stderr, "demlua_bench: {}\n", fault.what());
        return 1;
    }
}
