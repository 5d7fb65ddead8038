#include "engine/step/step.hpp"

#include "engine/base/memory.hpp"
#include "engine/step/bond_forces.hpp"
#include "engine/step/breaking.hpp"
#include "engine/step/contact_forces.hpp"
#include "engine/step/facet_sweep.hpp"
#include "engine/step/loads.hpp"
#include "engine/step/motion.hpp"
#include "engine/step/pair_sums.hpp"
#include "engine/step/removal.hpp"
#include "engine/step/rigid_motion.hpp"
#include "engine/step/stretch_rates.hpp"
#include "engine/step/waking.hpp"
#include "engine/step/wall_forces.hpp"
#include "engine/step/wall_motion.hpp"
#include "engine/step/wear.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <iterator>
#include <type_traits>

namespace demlua::step {

template <class Work>
void Clock::time(std::uint64_t step, Stage stage, const Work& work) {
    const std::uint64_t every = stage == Stage::search ? 1 : sampled_every;
    if (step % every != 0) {
        work();
        return;
    }
    const auto begin = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    seconds[static_cast<std::size_t>(stage)] += taken.count() * static_cast<double>(every);
}

namespace {

template <class Bonds>
void follow_rates(const state::State& state, Stepper& stepper, Bonds& bonds) {
    if constexpr (law::follows_rate<typename Bonds::law>) {
        const double weight = rate_weight(bonds, state.dt);
        stepper.team.share(bonds.size(), [&](Share part) { mean_rates(bonds, state.elements, weight, part); });
    }
}

template <class Law>
void compute_bonds(state::State& state, Stepper& stepper, state::BondSet<Law>& bonds) {
    follow_rates(state, stepper, bonds);
    refresh_quads(bonds, state.elements, *stepper.kernels, stepper.team);
    std::vector<Happened> shares(stepper.team.parts());
    stepper.team.share(bonds.size(), [&](Share part) {
        shares[part.part] = bond_forces(bonds, state.elements, state.dt, part, *stepper.kernels);
    });
    Happened happened;
    for (const Happened& share : shares) happened |= share;
    bonds.remembers = bonds.remembers || happened.yields;
    if (happened.fails || stepper.cut) {
        std::vector<NewContact> contacts;
        settle_broken(state, bonds, failing_rows(bonds), contacts);
        append_contacts(state, stepper.search, contacts);
    }
    add_pair_forces(bonds, state.elements, *stepper.kernels, stepper.team);
}

template <class Law>
void compute_bonds(state::State& state, Stepper& stepper, state::FacetSet<Law>& bonds) {
    std::vector<std::vector<Failing<Law>>> failing(stepper.team.parts());
    follow_rates(state, stepper, bonds);
    const Kernels& kernels = *stepper.kernels;
    refresh_quads(bonds, state.elements, kernels, stepper.team);
    if constexpr (Law::breaks) {
        std::swap(bonds.normal, bonds.normal_before);
        std::swap(bonds.shear, bonds.shear_before);
    }
    sweep_facets(bonds, state.elements, state.dt, kernels, stepper.team, failing);
    if constexpr (Law::breaks) {
        std::vector<NewContact> contacts;
        const std::vector<Index> breaking = settle_yielding(bonds, state.elements, failing);
        settle_broken(state, bonds, breaking, contacts);
        if (!breaking.empty()) refresh_around(bonds, state.elements, breaking);
        append_contacts(state, stepper.search, contacts);
    }
    if constexpr (Law::wakes) {
        stepper.team.share(bonds.size(), [&](Share part) { wake_facets(bonds, state.elements, kernels, part); });
    }
    add_pair_forces(bonds, state.elements, *stepper.kernels, stepper.team);
}

void check_drift(const state::State& state, const Drift& drift, double greatest_move) {
    if (drift.runaway == Drift::no_element) return;
    const std::size_t k = drift.runaway;
    const state::Elements& elements = state.elements;
    throw RunError(fmt::format("element {} of body \"{}\" at ({:.6g}, {:.6g}) m moved at ({:.6g}, {:.6g}) m/s in step "
                               "{} (t = {:.6g} s): more than {:.3g} of its radius {:.4g} m in one step of {:.4g} s",
                               k, state.bodies[elements.body[k]].name, elements.position(k).x, elements.position(k).y,
                               elements.vx[k], elements.vy[k], state.step, state.time, greatest_move,
                               elements.radius[k], state.dt));
}

} // namespace

Stepper::Stepper(Team& threads, const state::State& state, double greatest_share)
    : team(threads), kernels(&kernels_of(widest_kernels())),
      search(start_search(state)), limit{greatest_share, state.elements.size() > 0
                                                             ? *std::min_element(state.elements.radius.begin(),
                                                                                 state.elements.radius.end())
                                                             : 0.0} {}

void compute_forces(state::State& state, Stepper& stepper) {
    clear_forces(state, stepper.team);
    add_forces(state, stepper);
}

void add_forces(state::State& state, Stepper& stepper) {
    Clock& clock = stepper.clock;
    const std::uint64_t step = state.step;
    if (state.wear.present()) {
        clock.time(step, Stage::wear, [&] { stepper.cut = wear_out(state, stepper.search, stepper.team); });
    }
    if (in_doubt(stepper.search)) {
        clock.time(step, Stage::search, [&] {
            if (!state.gone.empty()) remove_leavers(state, stepper.domain);
            refresh_contacts(state, stepper.search, stepper.team);
        });
    }
    for (state::AnyBondSet& any : state.bond_sets) {
        clock.time(step, Stage::bonds,
                   [&] { std::visit([&](auto& bonds) { compute_bonds(state, stepper, bonds); }, any); });
    }
    if (state.contacts.size() > 0 && may_touch(stepper.search)) {
        clock.time(step, Stage::contacts,
                   [&] { contact_forces(state, stepper.records, *stepper.kernels, stepper.team); });
    }
    if (!state.walls.empty()) clock.time(step, Stage::walls, [&] { wall_forces(state, stepper.team); });
    if (!state.loads.empty()) clock.time(step, Stage::loads, [&] { add_loads(state); });
    if (!state.rigid_bodies.empty()) clock.time(step, Stage::rigid, [&] { gather_rigid(state, stepper.team); });
}

void advance(state::State& state, Stepper& stepper) {
    Clock& clock = stepper.clock;
    const std::uint64_t step = state.step;
    const bool driven = !state.loads.empty() || !state.drives.empty();
    if (audits_contacts && is_unknown(stepper.search)) stepper.audit = {};
    Drift moved;
    clock.time(step, Stage::motion,
               [&] { moved = move_elements(state, stepper.limit, *stepper.kernels, stepper.team); });
    if (!state.rigid_bodies.empty()) moved.join(move_rigid(state, stepper.limit.share, stepper.team));
    check_drift(state, moved, stepper.limit.share);
    if (!state.walls.empty()) moved.farthest = std::max(moved.farthest, move_walls(state, stepper.limit));
    if (driven) book_work(state);
    travel(stepper.search, moved.farthest);
    ++state.step;
    state.time += state.dt;

    add_forces(state, stepper);
    if constexpr (audits_contacts) stepper.audit.book(state);
    if (!state.walls.empty()) book_wall_work(state);
    if (!state.drives.empty()) apply_drives(state);
    if (driven) book_work(state);
}

void start(state::State& state, Stepper& stepper) {
    double fastest = 0.0;
    for (std::size_t k = 0; k < state.elements.size(); ++k)
        fastest = std::max(fastest, norm(state.elements.velocity(k)));
    travel(stepper.search, fastest * state.dt);
    refresh_contacts(state, stepper.search, stepper.team);
    const double dt = std::exchange(state.dt, 0.0);
    compute_forces(state, stepper);
    change_step(state, dt);
    if (!state.drives.empty()) apply_drives(state);
    give_back_memory();
}

void change_step(state::State& state, double dt) {
    const double old = std::exchange(state.dt, dt);
    state::Elements& elements = state.elements;
    const Kick kicked(state.alpha, old);
    const auto shifted = [&](double v, double force, double inverse_mass) {
        const double now = 0.5 * (v + kicked(v, force, inverse_mass));
        return (1.0 + 0.5 * state.alpha * dt) * now - 0.5 * dt * force * inverse_mass;
    };
    for (std::size_t k = 0; k < elements.size(); ++k) {
        elements.vx[k] = shifted(elements.vx[k], elements.fx[k], elements.inverse_mass[k]);
        elements.vy[k] = shifted(elements.vy[k], elements.fy[k], elements.inverse_mass[k]);
        elements.spin[k] = shifted(elements.spin[k], elements.moment[k], elements.inverse_inertia[k]);
    }
    for (state::RigidBody& rigid : state.rigid_bodies) {
        if (rigid.empty()) continue;
        rigid.velocity = {shifted(rigid.velocity.x, rigid.force.x, 1.0 / rigid.mass),
                          shifted(rigid.velocity.y, rigid.force.y, 1.0 / rigid.mass)};
        rigid.spin = shifted(rigid.spin, rigid.moment, 1.0 / rigid.inertia);
    }
    for (state::Wall& wall : state.walls) {
        const Vec2 force = wall.force + wall.weight(state.gravity);
        if (wall.free_x()) wall.velocity.x = shifted(wall.velocity.x, force.x, 1.0 / wall.matter->mass);
        if (wall.free_y()) wall.velocity.y = shifted(wall.velocity.y, force.y, 1.0 / wall.matter->mass);
        if (wall.free_to_turn()) wall.spin = shifted(wall.spin, wall.moment, 1.0 / wall.matter->inertia);
    }
}

std::string schedule_line(const state::State& state) {
    std::vector<std::string> used;
    std::vector<std::string> unused;
    const auto stage = [&](bool present, const std::string& with, const std::string& without) {
        present ? used.push_back(with) : unused.push_back(without);
    };
    bool dashpots = false;
    for (const state::AnyBondSet& any : state.bond_sets) {
        std::visit(
            [&](const auto& bonds) {
                using Law = typename std::decay_t<decltype(bonds)>::law;
                const bool damped = bonds.dashpots.present();
                dashpots = dashpots || damped;
                used.push_back(fmt::format("bonds of {}[{}{}{}{}]", state.bodies[bonds.body].name, Law::name,
                                           law::follows_rate<Law> ? ", strain rates" : "", damped ? ", dashpots" : "",
                                           state.mixed_precision ? ", mixed precision" : ""));
            },
            any);
    }
    if (state.bond_sets.empty()) unused.emplace_back("bonds");
    if (!state.bond_sets.empty() && !dashpots) unused.emplace_back("bond dashpots");
    used.push_back(fmt::format("contacts[coulomb{}, {} pairs in reach]", state.contacts.rolls ? ", rolling" : "",
                               state.contacts.size()));
    stage(state.wear.present(), "wear", "wear");
    stage(state.period.repeats(), "periodic x", "periodic x");
    stage(!state.gone.empty(), "removal", "removal");
    std::size_t outlines = 0;
    for (const state::Wall& wall : state.walls) outlines += wall.matter ? 1 : 0;
    stage(state.walls.size() > outlines, fmt::format("walls[{}]", state.walls.size() - outlines), "walls");
    stage(outlines > 0, fmt::format("outlines[{}]", outlines), "outlines");
    stage(!state.loads.empty(), fmt::format("loads[{}]", state.loads.size()), "loads");
    stage(!state.drives.empty(), fmt::format("supports and given motions[{}]", state.drives.size()),
          "supports and given motions");
    stage(!state.rigid_bodies.empty(), fmt::format("rigid bodies[{}]", state.rigid_bodies.size()), "rigid bodies");
    stage(state.gravity != Vec2{}, "gravity", "gravity");
    stage(state.alpha > 0.0, "mass damping", "mass damping");
    used.emplace_back("motion");
    return fmt::format("step: {}; unused: {}", fmt::join(used, " > "),
                       unused.empty() ? std::string("nothing") : fmt::format("{}", fmt::join(unused, ", ")));
}

} // namespace demlua::step
