#include "engine/step/held.hpp"

#include "engine/state/parts.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace demlua::step {

namespace {

Eigen::Index row_of(std::size_t element, state::Freedom freedom) {
    return static_cast<Eigen::Index>(3 * element + static_cast<std::size_t>(freedom));
}

double displacement_of(const state::Elements& elements, state::Freedom freedom, std::size_t k) {
    return freedom == state::Freedom::x ? elements.ux[k] : elements.uy[k];
}

/// Whether what is held of the part leaves it a motion as a rigid whole.
bool floats(const state::Elements& elements, const std::vector<std::size_t>& part, const Held& held) {
    constexpr double nothing = 1e-10;
    Vec2 centre;
    for (const std::size_t k : part) centre += elements.position(k) / static_cast<double>(part.size());
    double size = 0.0;
    for (const std::size_t k : part) size = std::max(size, norm(elements.position(k) - centre) + elements.radius[k]);
    Eigen::Matrix3d known = Eigen::Matrix3d::Zero();
    for (const std::size_t k : part) {
        const Vec2 arm = (elements.position(k) - centre) / size;
        const Eigen::Vector3d of_x{1.0, 0.0, -arm.y};
        const Eigen::Vector3d of_y{0.0, 1.0, arm.x};
        const Eigen::Vector3d of_rotation{0.0, 0.0, 1.0};
        if (held.is[3 * k] != 0) known += of_x * of_x.transpose();
        if (held.is[3 * k + 1] != 0) known += of_y * of_y.transpose();
        if (held.is[3 * k + 2] != 0) known += of_rotation * of_rotation.transpose();
    }
    const Eigen::Vector3d values =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(known, Eigen::EigenvaluesOnly).eigenvalues();
    return values[0] <= nothing * values[2];
}

} // namespace

Held held_freedoms(const state::State& state) {
    const state::Elements& elements = state.elements;
    Held held;
    held.is.resize(3 * elements.size());
    held.jump = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(held.is.size()));
    for (const state::Drive& drive : state.drives) {
        for (std::size_t n = 0; n < drive.element.size(); ++n) {
            const std::size_t k = drive.element[n];
            const Eigen::Index row = row_of(k, drive.freedom);
            held.is[static_cast<std::size_t>(row)] = 1;
            held.jump[row] = drive.is_displacement ? drive.begin[n] + drive.value.at(state.time) -
                                                         displacement_of(elements, drive.freedom, k)
                                                   : 0.0;
        }
    }
    return held;
}

std::vector<std::vector<std::size_t>> floating_parts(const state::State& state, const Held& held) {
    std::vector<std::vector<std::size_t>> parts = state::elements_of_parts(state);
    const auto stays = [&](const std::vector<std::size_t>& part) { return !floats(state.elements, part, held); };
    parts.erase(std::remove_if(parts.begin(), parts.end(), stays), parts.end());
    return parts;
}

} // namespace demlua::step
