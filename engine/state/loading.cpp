#include "engine/state/loading.hpp"

#include "engine/state/selection.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace demlua::state {

namespace {

Column<Index> selected_or_refused(const model::Selection& selection, const State& state, const Place& place,
                                  const char* what) {
    Column<Index> rows = selected(selection, state);
    if (rows.empty()) {
        throw SceneError(Problem{place, what, "", "its selection holds no element", "look at the region and the body"});
    }
    return rows;
}

/// Elements of rigid bodies are driven through their body.
Drive drive_of(const Column<Index>& rows, const State& state, Freedom freedom, const Signal& value,
               bool is_displacement) {
    Drive drive;
    drive.freedom = freedom;
    drive.value = value;
    drive.is_displacement = is_displacement;
    for (const Index k : rows) {
        const std::optional<std::size_t> rigid = state.rigid_of(k);
        if (!rigid) {
            drive.element.push_back(k);
            const Elements& elements = state.elements;
            if (is_displacement) drive.begin.push_back(freedom == Freedom::x ? elements.ux[k] : elements.uy[k]);
        } else {
            drive.rigid.push_back(*rigid);
        }
    }
    std::sort(drive.rigid.begin(), drive.rigid.end());
    drive.rigid.erase(std::unique(drive.rigid.begin(), drive.rigid.end()), drive.rigid.end());
    drive.reaction.resize(drive.element.size());
    drive.rigid_reaction.resize(drive.rigid.size());
    return drive;
}

bool runs_along_x(model::Side side) { return side == model::Side::top || side == model::Side::bottom; }

/// How far (m) a loaded side goes on beyond its end element: to the region's edge, where that is no farther than `reach`; else
/// to the end of the element's disk.
double side_beyond(const model::Region& region, Vec2 centre, Vec2 along, double radius, double reach) {
    const double on_edge = 1e-10 * radius;
    const auto inside = [&](double beyond) { return region.distance(centre + beyond * along) <= on_edge; };
    if (region.bounds().empty() || inside(reach)) return radius;
    double near = 0.0;
    double far = reach;
    for (int halving = 0; halving < 50; ++halving) {
        const double middle = 0.5 * (near + far);
        (inside(middle) ? near : far) = middle;
    }
    return near;
}

} // namespace

std::vector<Drive> drives_of(const model::Support& support, const State& state) {
    const Column<Index> rows = selected_or_refused(support.selection, state, support.place, "fix");
    const Signal still = Signal::constant(0.0);
    std::vector<Drive> drives;
    if (support.x) drives.push_back(drive_of(rows, state, Freedom::x, still, false));
    if (support.y) drives.push_back(drive_of(rows, state, Freedom::y, still, false));
    if (support.rotation) drives.push_back(drive_of(rows, state, Freedom::rotation, still, false));
    return drives;
}

Column<Index> rows_of(const model::Motion& motion, const State& state) {
    return selected_or_refused(motion.selection, state, motion.place, "move");
}

std::vector<Drive> drives_of(const model::Motion& motion, const Column<Index>& rows, const State& state) {
    std::vector<Drive> drives;
    const auto drive = [&](Freedom freedom, const std::optional<Signal>& value, bool is_displacement) {
        if (value) drives.push_back(drive_of(rows, state, freedom, *value, is_displacement));
    };
    drive(Freedom::x, motion.velocity_x, false);
    drive(Freedom::y, motion.velocity_y, false);
    drive(Freedom::x, motion.displacement_x, true);
    drive(Freedom::y, motion.displacement_y, true);
    drive(Freedom::rotation, motion.spin, false);
    return drives;
}

Load load_of(const model::Force& force, const State& state) {
    Load load;
    load.element = selected_or_refused(force.selection, state, force.place, "force");
    load.share.assign(load.element.size(), 1.0 / static_cast<double>(load.element.size()));
    load.x = force.x;
    load.y = force.y;
    return load;
}

Load load_of(const model::Traction& traction, const model::Body& body, const State& state) {
    const Elements& elements = state.elements;
    const bool along_x = runs_along_x(traction.selection.side.value());
    const auto place_along = [&](Index k) { return along_x ? elements.position(k).x : elements.position(k).y; };
    Load load;
    load.element = selected_or_refused(traction.selection, state, traction.place, "traction");
    std::stable_sort(load.element.begin(), load.element.end(),
                     [&](Index a, Index b) { return place_along(a) < place_along(b); });

    const Vec2 along = along_x ? Vec2{1.0, 0.0} : Vec2{0.0, 1.0};
    // In an irregular pack the element in a corner may lie too deep to count as one of the side.
    const bool whole = !traction.selection.within && !traction.selection.where;
    const auto beyond = [&](Index k, Vec2 way) {
        const double radius = elements.radius[k];
        return side_beyond(body.region, elements.position(k), way, radius, whole ? 4.0 * radius : radius);
    };
    const Index first = load.element.front();
    const Index last = load.element.back();
    double begin = place_along(first) - beyond(first, -along);
    const double end = place_along(last) + beyond(last, along);
    for (std::size_t n = 0; n < load.element.size(); ++n) {
        const bool is_last = n + 1 == load.element.size();
        const double next = is_last ? end : 0.5 * (place_along(load.element[n]) + place_along(load.element[n + 1]));
        load.share.push_back((next - begin) * state.thickness);
        begin = next;
    }
    load.x = traction.stress_x;
    load.y = traction.stress_y;
    return load;
}

std::vector<Drive> drives_of(const model::Traction& traction, const State& state) {
    if (!traction.hold_rotation) return {};
    const Column<Index> rows = selected_or_refused(traction.selection, state, traction.place, "traction");
    return {drive_of(rows, state, Freedom::rotation, Signal::constant(0.0), false)};
}

} // namespace demlua::state
