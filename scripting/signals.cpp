#include "scripting/signals.hpp"

#include "engine/model/settings.hpp"
#include "scripting/read.hpp"
#include "scripting/sample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace demlua::scripting {

using namespace model;

namespace {

constexpr std::array all_kinds{LoadKind::motion, LoadKind::force, LoadKind::traction,
                               LoadKind::wall,   LoadKind::servo, LoadKind::outline};

/// Where a function of time ends up: the signal, and the address by which its slot is known.
struct Target {
    Signal* signal;
    const void* address;
};

Target target_of(Scene& scene, const TimeFunction& said) {
    const Slot slot = word_of(said.load.kind).find(said.setting)->slot(row_of(scene, said.load));
    const auto of_optional = [](std::optional<Signal>* signal) { return Target{&signal->value(), signal}; };
    if (auto* const* plain = std::get_if<Signal*>(&slot)) return {*plain, *plain};
    if (auto* const* single = std::get_if<std::optional<Signal>*>(&slot)) return of_optional(*single);
    const auto& pair = std::get<SignalPairSlot>(slot);
    return of_optional(said.component == 0 ? pair.x : pair.y);
}

/// What a slot was told before no longer counts.
void forget(Context& context, const void* target) {
    auto& said = context.time_functions;
    said.erase(
        std::remove_if(said.begin(), said.end(),
                       [&](const TimeFunction& each) { return target_of(context.scene, each).address == target; }),
        said.end());
}

/// { { time, value }, ... }; order and finiteness are the model checker's business.
bool read_pairs(lua_State* L, int table, Signal& signal) {
    signal = {{}, {}};
    const auto length = static_cast<lua_Integer>(lua_rawlen(L, table));
    bool good = length > 0;
    for (lua_Integer k = 1; k <= length && good; ++k) {
        lua_rawgeti(L, table, k);
        good = lua_type(L, -1) == LUA_TTABLE && lua_rawlen(L, -1) == 2;
        if (good) {
            lua_rawgeti(L, -1, 1);
            lua_rawgeti(L, -2, 2);
            good = lua_type(L, -1) == LUA_TNUMBER && lua_type(L, -2) == LUA_TNUMBER;
            signal.times.push_back(lua_tonumber(L, -2));
            signal.values.push_back(lua_tonumber(L, -1));
            lua_pop(L, 2);
        }
        lua_pop(L, 1);
    }
    return good;
}

double value_at(const TimeFunction& said, double time) {
    Interpreter& interpreter = said.function.push();
    lua_State* const L = interpreter.L;
    lua_pushnumber(L, time);
    interpreter.call(L, 1, 1);
    const bool good = lua_type(L, -1) == LUA_TNUMBER && std::isfinite(lua_tonumber(L, -1));
    const double value = lua_tonumber(L, -1);
    const std::string given = describe(L, -1);
    lua_pop(L, 1);
    if (good) return value;
    throw SceneError(Problem{said.place, word_of(said.load.kind).name() + "." + said.setting, given,
                             fmt::format("must return a finite number at time {} s", time), ""});
}

/// Samples one function into its place in the scene; what is wrong with it is complained of.
void sample_one(Context& context, const TimeFunction& said, double begin, double end) {
    constexpr double greatest_error = 1e-3;
    try {
        const Sampled sampled = sample([&](double time) { return value_at(said, time); }, begin, end);
        *target_of(context.scene, said).signal = sampled.signal;
        if (sampled.error <= greatest_error) return;
        context.complain({said.place, word_of(said.load.kind).name() + "." + said.setting, "",
                          fmt::format("changes too fast: {} samples over {} s leave an error of {:.1g}",
                                      greatest_sample_count, end - begin, sampled.error),
                          ""},
                         Cause::value);
    } catch (const SceneError& error) {
        for (const Problem& problem : error.problems()) context.complain(problem, Cause::value);
    }
}

void replace(observe::Simulation& simulation, const Scene& scene, const LoadHandle& load) {
    switch (load.kind) {
    case LoadKind::motion:
        return simulation.replace_motion(load.row, scene.motions[load.row]);
    case LoadKind::force:
        return simulation.replace_force(load.row, scene.forces[load.row]);
    case LoadKind::traction:
        return simulation.replace_traction(load.row, scene.tractions[load.row]);
    case LoadKind::wall:
    case LoadKind::servo:
        return simulation.replace_wall(load.row, scene.walls[load.row]);
    case LoadKind::outline:
        return simulation.replace_outline(load.row, scene.outlines[load.row]);
    }
}

} // namespace

const Word& word_of(LoadKind kind) {
    switch (kind) {
    case LoadKind::motion:
        return words::move();
    case LoadKind::force:
        return words::force();
    case LoadKind::traction:
        return words::traction();
    case LoadKind::servo:
        return words::servo();
    case LoadKind::outline:
        return words::outline_move();
    case LoadKind::wall:
        break;
    }
    return words::wall();
}

void* row_of(Scene& scene, const LoadHandle& load) {
    switch (load.kind) {
    case LoadKind::motion:
        return &scene.motions[load.row];
    case LoadKind::force:
        return &scene.forces[load.row];
    case LoadKind::traction:
        return &scene.tractions[load.row];
    case LoadKind::servo:
        return &scene.walls[load.row].servo.value();
    case LoadKind::outline:
        return &scene.outlines[load.row];
    case LoadKind::wall:
        break;
    }
    return &scene.walls[load.row];
}

std::size_t count_of(const Scene& scene, LoadKind kind) {
    switch (kind) {
    case LoadKind::motion:
        return scene.motions.size();
    case LoadKind::force:
        return scene.forces.size();
    case LoadKind::traction:
        return scene.tractions.size();
    case LoadKind::outline:
        return scene.outlines.size();
    case LoadKind::wall:
    case LoadKind::servo:
        break;
    }
    return scene.walls.size();
}

void forget_functions(Context& context, const LoadHandle& load) {
    auto& said = context.time_functions;
    said.erase(std::remove_if(said.begin(), said.end(), [&](const TimeFunction& each) { return each.load == load; }),
               said.end());
}

void read_signal(const Value& value, const Slot& slot, int at, int component, Signal& signal, const void* target) {
    lua_State* const L = value.call.L;
    Context& context = value.call.context;
    const bool on_load = value.call.load.has_value();
    if (lua_type(L, at) == LUA_TFUNCTION && on_load) {
        forget(context, target);
        context.time_functions.push_back(
            {*value.call.load, value.setting.name, component, Function(L, at), value.call.place});
        return;
    }
    Signal said;
    if (const auto* made = test<Signal>(L, at)) {
        said = *made;
    } else if (lua_type(L, at) != LUA_TTABLE) {
        const std::optional<double> number = value.number(at, slot);
        if (!number) return;
        said = Signal::constant(*number);
    } else if (!read_pairs(L, at, said)) {
        return value.wrong_type(slot);
    }
    if (on_load) forget(context, target);
    signal = std::move(said);
}

std::vector<PresentValue> present_values(Context& context, const LoadHandle& load) {
    const auto value = [&](const Signal& signal) { return signal.at(context.time()); };
    std::vector<PresentValue> values;
    for (const Setting& setting : word_of(load.kind).settings) {
        const Slot slot = setting.slot(row_of(context.scene, load));
        if (auto* const* plain = std::get_if<Signal*>(&slot)) {
            values.push_back({setting.name, value(**plain)});
        } else if (auto* const* single = std::get_if<std::optional<Signal>*>(&slot)) {
            const std::optional<Signal>& said = **single;
            values.push_back({setting.name, said ? std::optional<double>(value(*said)) : std::nullopt});
        }
    }
    return values;
}

void sample_time_functions(Context& context, double begin, double end) {
    for (const TimeFunction& said : context.time_functions) {
        sample_one(context, said, begin, end);
        context.changed.push_back(said.load);
    }
}

void sample_changed(Context& context, double begin, double end) {
    for (const TimeFunction& said : context.time_functions) {
        if (std::find(context.changed.begin(), context.changed.end(), said.load) == context.changed.end()) continue;
        sample_one(context, said, begin, end);
    }
}

void pass_on_changes(Context& context) {
    observe::Simulation* const simulation = context.simulation();
    if (simulation != nullptr && !context.assembled.empty()) {
        for (const LoadHandle& load : context.changed) {
            if (load.row < context.assembled[load.kind]) replace(*simulation, context.scene, load);
        }
        if (context.grown) simulation->take_in(context.scene);
        note_assembled(context);
    }
    context.changed.clear();
    context.grown = false;
}

void note_assembled(Context& context) {
    for (const LoadKind kind : all_kinds) context.assembled[kind] = count_of(context.scene, kind);
}

} // namespace demlua::scripting
