// Bonds that yield or break while loads grow slowly, by the law each set has.
#pragma once

#include "engine/step/bond_offsets.hpp"
#include "engine/step/breaking.hpp"
#include "engine/step/waking.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace demlua::step {

/// The law's parameters where bond `k` gives way against a stiffness, and the stiffness they are for: facets are told the
/// one they meet, pairs know their own.
template <class Law>
std::pair<typename Law::Params, law::ContactStiffness>
params_against(const state::BondSet<Law>& bonds, std::size_t /*k*/, law::ContactStiffness /*met*/) {
    return {bonds.params, {bonds.params.Kn, bonds.params.Kt}};
}

template <class Law>
std::pair<typename Law::Params, law::ContactStiffness> params_against(const state::FacetSet<Law>& bonds, std::size_t k,
                                                                      law::ContactStiffness met) {
    return {Law::on_facet(bonds.tractions, met, bonds.area[k], bonds.radius[k]), met};
}

/// How much of what bond `k` bears now `force` takes up.
template <class Bonds>
double share_of_strength(const Bonds& bonds, const state::Elements& elements, std::size_t k,
                         law::BondForce<double> force) {
    using Law = typename Bonds::law;
    if constexpr (Law::wakes) {
        return share_of_waking(bonds, elements, k);
    } else if constexpr (Law::breaks) {
        const auto caps = Law::caps(params_of(bonds, k), law_radius(bonds, k), bonds.history.at(k));
        return std::max(force.normal / caps.normal, std::fabs(force.shear) / caps.shear);
    }
    return 0.0;
}

/// What a bond did under a force it could not bear.
struct GivenWay {
    Eigen::Vector2d moved = Eigen::Vector2d::Zero(); ///< new part of its offset, m
    double beyond = 0.0;                             ///< force that was more than it could bear, N
};

/// A direction in which a bond's offset moves while its force grows: by along * (slope . change of force).
struct Way {
    Eigen::Vector2d along; ///< of norm 1
    Eigen::Vector2d slope; ///< m/N
    bool back = false;     ///< whether it also moves back
};

/// One bond that has failed in some way: its offset w (bond_offsets.hpp) since bonding and what its law remembers.
class FailingBonds {
public:
    FailingBonds() = default;
    virtual ~FailingBonds() = default;
    FailingBonds(const FailingBonds&) = delete;
    FailingBonds& operator=(const FailingBonds&) = delete;
    FailingBonds(FailingBonds&&) = delete;
    FailingBonds& operator=(FailingBonds&&) = delete;

    // --- all bonds of the set ----------------------------------------------------------------------------------------
    [[nodiscard]] virtual std::size_t bonds() const = 0;
    /// Share of the nearest to failing from which on bonds are let fail with it.
    [[nodiscard]] virtual double together() const = 0;
    /// Middle between the elements of bond `k` at the start, m.
    [[nodiscard]] virtual Vec2 place(std::size_t k) const = 0;
    /// Bonds that hold and have an offset from before.
    [[nodiscard]] virtual std::vector<std::size_t> offset_before() const = 0;
    /// Finds the forces in all bonds under displacements `u` and the rows' offsets.
    virtual void measure(const Eigen::VectorXd& u) = 0;
    /// How far bond `k` has come to failing as last measured: 1 when it would yield or break. 0 for those that have a row.
    [[nodiscard]] virtual double use(std::size_t k) const = 0;
    [[nodiscard]] virtual ElementForces offset_forces(std::size_t k, Eigen::Vector2d w) const = 0;
    [[nodiscard]] virtual Eigen::Matrix2d coupling(std::size_t k, std::size_t m) const = 0;

    // --- rows --------------------------------------------------------------------------------------------------------
    /// Gives bond `k`, as last measured, a row.
    virtual std::size_t add_row(std::size_t k) = 0;
    [[nodiscard]] virtual std::size_t bond(std::size_t row) const = 0;
    [[nodiscard]] virtual Eigen::Vector2d offset(std::size_t row) const = 0;
    /// A force that is large for this bond, N.
    [[nodiscard]] virtual double strength(std::size_t row) const = 0;
    [[nodiscard]] virtual std::size_t broken_rows() const = 0;
    /// Lets the bond of `row` give way under `force` (N), where an offset w meets `stiffness` (N/m, normal and shear;
    /// positive), by its law.
    virtual GivenWay give_way(std::size_t row, Eigen::Vector2d force, Eigen::Vector2d stiffness) = 0;
    /// What give_way reckons with where an offset meets `stiffness`.
    [[nodiscard]] virtual Eigen::Vector2d reckoned(std::size_t row, Eigen::Vector2d stiffness) const = 0;
    /// What give_way would answer; nothing changes.
    [[nodiscard]] virtual GivenWay would_give(std::size_t row, Eigen::Vector2d force,
                                              Eigen::Vector2d stiffness) const = 0;
    /// Ways of a row that last moved by `moved`; none where that says nothing about how it moves on.
    [[nodiscard]] virtual std::vector<Way> ways(std::size_t row, Eigen::Vector2d force, Eigen::Vector2d stiffness,
                                                Eigen::Vector2d moved) const = 0;
    /// Rows as they are now come back with `restore`; rows added since are lost.
    virtual void keep() = 0;
    virtual void restore() = 0;
    /// Writes histories into the set and takes broken bonds out of it.
    virtual void settle(state::State& state, std::vector<NewContact>& contacts) = 0;
};

template <class Bonds>
class FailingBondsOf final : public FailingBonds {
public:
    using Law = typename Bonds::law;
    using History = typename Bonds::History;

    /// `contact` is what a broken bond turns into.
    FailingBondsOf(Bonds& bonds, const state::Elements& elements, const law::Coulomb::Params& contact)
        : bonds_(bonds), elements_(elements), network_(bonds), contact_(contact), row_of_(bonds.size(), none) {}

    [[nodiscard]] std::size_t bonds() const override { return bonds_.size(); }
    [[nodiscard]] double together() const override {
        constexpr double nearly = 0.98;
        constexpr double tied = 1.0 - 1e-6;
        return Law::yields ? nearly : tied;
    }
    [[nodiscard]] Vec2 place(std::size_t k) const override {
        const std::size_t i = bonds_.i[k];
        return {elements_.reference_x[i] + 0.5 * bonds_.Dx[k], elements_.reference_y[i] + 0.5 * bonds_.Dy[k]};
    }

    [[nodiscard]] std::vector<std::size_t> offset_before() const override {
        std::vector<std::size_t> found;
        if constexpr (Law::yields) {
            for (std::size_t k = 0; k < bonds_.size(); ++k) {
                if (bonds_.is_broken(k)) continue;
                const History history = bonds_.history.at(k);
                if (history.stretch != 0.0 || history.shear != 0.0) found.push_back(k);
            }
        }
        return found;
    }

    void measure(const Eigen::VectorXd& u) override {
        force_ = network_forces(network_, u);
        for (const Row& row : rows_) add_offset(row);
        if constexpr (Law::wakes) {
            for (std::size_t k = 0; k < force_.size(); ++k) {
                network_.normal[k] = force_[k][0];
                network_.shear[k] = force_[k][1];
            }
        }
    }

    [[nodiscard]] double use(std::size_t k) const override {
        if (network_.is_broken(k) || row_of_[k] != none) return 0.0;
        return share_of_strength(network_, elements_, k, {force_[k][0], force_[k][1]});
    }

    [[nodiscard]] ElementForces offset_forces(std::size_t k, Eigen::Vector2d w) const override {
        return step::offset_forces(network_, k, w);
    }
    [[nodiscard]] Eigen::Matrix2d coupling(std::size_t k, std::size_t m) const override {
        return offset_coupling(network_, k, m);
    }

    std::size_t add_row(std::size_t k) override {
        Row row;
        row.bond = k;
        row.history = bonds_.history.at(k);
        if constexpr (Law::yields) row.offset = {row.history.stretch, row.history.shear};
        if constexpr (Law::wakes) {
            // Under slow loads it woke where it came to its strength, wherever the last event has left it.
            if (row.history.cap == 0.0) {
                row.history.cap = Law::pull(law::BondForce<double>{force_[k][0], force_[k][1]}) / std::max(1.0, use(k));
            }
        }
        row.borne = {force_[k][0], force_[k][1]};
        row.strength = row.borne.cwiseAbs().maxCoeff();
        row_of_[k] = rows_.size();
        rows_.push_back(row);
        return rows_.size() - 1;
    }
    [[nodiscard]] std::size_t bond(std::size_t row) const override { return rows_[row].bond; }
    [[nodiscard]] Eigen::Vector2d offset(std::size_t row) const override { return rows_[row].offset; }
    [[nodiscard]] double strength(std::size_t row) const override { return rows_[row].strength; }
    [[nodiscard]] std::size_t broken_rows() const override {
        return static_cast<std::size_t>(
            std::count_if(rows_.begin(), rows_.end(), [](const Row& row) { return row.broken; }));
    }

    GivenWay give_way(std::size_t number, Eigen::Vector2d force, Eigen::Vector2d stiffness) override {
        Row& row = rows_[number];
        GivenWay given = row.broken ? part(row, force, stiffness) : yield(row, force, stiffness);
        row.offset += given.moved;
        return given;
    }

    [[nodiscard]] Eigen::Vector2d reckoned(std::size_t number, Eigen::Vector2d stiffness) const override {
        if constexpr (Law::breaks) {
            const Row& row = rows_[number];
            if (row.broken) return stiffness;
            const law::ContactStiffness met = params_against(network_, row.bond, {stiffness[0], stiffness[1]}).second;
            return {met.normal, met.shear};
        }
        return stiffness;
    }

    [[nodiscard]] GivenWay would_give(std::size_t number, Eigen::Vector2d force,
                                      Eigen::Vector2d stiffness) const override {
        Row row = rows_[number];
        return row.broken ? part(row, force, stiffness) : yield(row, force, stiffness);
    }

    /// Slopes by differences, just beyond what it bears. Broken and open, it moves either way freely.
    [[nodiscard]] std::vector<Way> ways(std::size_t number, Eigen::Vector2d force, Eigen::Vector2d stiffness,
                                        Eigen::Vector2d moved) const override {
        const Row& row = rows_[number];
        if (row.broken) {
            const bool touches = force[0] <= stiffness[0] * (row.closed - row.offset[0]);
            if (touches || !(stiffness[1] > 0.0)) return {};
            return {{Eigen::Vector2d::UnitX(), {1.0 / stiffness[0], 0.0}, true},
                    {Eigen::Vector2d::UnitY(), {0.0, 1.0 / stiffness[1]}, true}};
        }
        constexpr double small = 1e-3;
        const double push = small * row.strength;
        const Eigen::Vector2d along = moved.normalized();
        const Eigen::Vector2d beyond = force + push * reckoned(number, stiffness).cwiseProduct(along).normalized();
        Eigen::Matrix2d slopes; // d moved/d force
        for (const Eigen::Index c : {0, 1}) {
            const Eigen::Vector2d half = 0.5 * push * Eigen::Vector2d::Unit(c);
            Row more = row;
            Row less = row;
            slopes.col(c) =
                (yield(more, beyond + half, stiffness).moved - yield(less, beyond - half, stiffness).moved) / push;
            if (more.broken || less.broken) return {};
        }
        const double least = small * slopes.squaredNorm();
        if (std::fabs(slopes.determinant()) < least) return {{along, slopes.transpose() * along, false}};
        const Eigen::Vector2d sign = along.cwiseSign();
        return {{sign[0] * Eigen::Vector2d::UnitX(), sign[0] * slopes.row(0), false},
                {sign[1] * Eigen::Vector2d::UnitY(), sign[1] * slopes.row(1), false}};
    }

    void keep() override { kept_ = rows_; }
    void restore() override {
        for (std::size_t n = kept_.size(); n < rows_.size(); ++n) row_of_[rows_[n].bond] = none;
        rows_ = kept_;
    }

    void settle(state::State& state, std::vector<NewContact>& contacts) override {
        std::vector<Index> breaking;
        double released = 0.0;
        for (Row& row : rows_) {
            if constexpr (Law::yields) {
                row.history.stretch = row.offset[0];
                row.history.shear = row.offset[1];
            }
            if (!row.settled) bonds_.remember(row.bond, row.history);
            if (!row.broken || row.settled) continue;
            breaking.push_back(static_cast<Index>(row.bond));
            released += row.released;
            row.settled = true;
        }
        std::sort(breaking.begin(), breaking.end());
        const double before = bonds_.fracture_work;
        const std::size_t first_contact = contacts.size();
        const std::size_t first_crack = state.cracks.size();
        settle_broken(state, bonds_, breaking, contacts);
        bonds_.fracture_work = before + released;
        for (std::size_t n = 0; n < breaking.size(); ++n) {
            const Row& row = rows_[row_of_[breaking[n]]];
            const Faces faces = faces_of(state, row);
            contacts[first_contact + n].reference = faces.reference;
            contacts[first_contact + n].history = faces.history;
            if constexpr (Law::breaks) {
                state.cracks[first_crack + n].energy = plastic_work(bonds_, row.bond) + row.released;
            }
        }
        for (Row& row : rows_) {
            if (row.settled) settle_faces(state, row);
        }
    }

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    struct Row {
        std::size_t bond = 0;
        History history{};
        Eigen::Vector2d offset = Eigen::Vector2d::Zero();
        Eigen::Vector2d borne = Eigen::Vector2d::Zero(); ///< when it was added, N
        double strength = 0.0;
        bool broken = false;
        bool settled = false;  ///< broken in the set as well
        double closed = 0.0;   ///< normal offset at which the faces of a broken bond touch, m
        double released = 0.0; ///< stored in the bond when it broke, J
        double rubbed = 0.0;   ///< slip of a broken bond at the last rest, m
        double cap = 0.0;      ///< friction there, N; 0 while open
    };

    /// What a contact is to know of the faces of a broken bond at rest.
    struct Faces {
        double reference = 0.0; ///< m
        double cap = 0.0;       ///< friction, N
        state::ContactHistory history;
    };

    /// From offsets and forces of the rest, not from how far the elements stand apart: a cell under stress is longer or shorter.
    [[nodiscard]] Faces faces_of(const state::State& state, const Row& row) const {
        constexpr double rounding = 1e-12; // of the bond's length
        const double distance = state.distance(bonds_.i[row.bond], bonds_.j[row.bond]);
        const double gap = row.offset[0] - row.closed;
        if (gap > rounding * distance) return {distance - gap, 0.0, {}};
        const double pressed = std::max(0.0, -force_[row.bond][0]);
        Faces faces{distance + pressed / contact_.Kn, contact_.mu * pressed, {}};
        if (!(contact_.Kt > 0.0)) return faces;
        faces.history.force = std::clamp(force_[row.bond][1], -faces.cap, faces.cap);
        faces.history.shear = faces.history.force / contact_.Kt;
        return faces;
    }

    /// Brings the contact of a broken bond up to date and books what its faces have rubbed since the last rest.
    void settle_faces(state::State& state, Row& row) {
        const Faces faces = faces_of(state, row);
        const double slip = std::fabs(row.offset[1] - row.rubbed);
        if (row.cap > 0.0 && faces.cap > 0.0) {
            state.contacts.booked.friction += 0.5 * (row.cap + faces.cap) * slip;
        }
        row.rubbed = row.offset[1];
        row.cap = faces.cap;
        if constexpr (Law::breaks) bonds_.contact_length[row.bond] = faces.reference;
        state::Contacts& list = state.contacts;
        for (std::size_t c = 0; c < list.size(); ++c) {
            if (list.i[c] != bonds_.i[row.bond] || list.j[c] != bonds_.j[row.bond]) continue;
            list.reference[c] = faces.reference;
            list.history.store(c, faces.history);
        }
    }

    /// By the law of the bond while it holds. One that breaks without yielding does so under what it bore when it was added,
    /// for bonds added with it may have relieved it since.
    GivenWay yield(Row& row, Eigen::Vector2d force, Eigen::Vector2d stiffness) const {
        if constexpr (Law::breaks && !Law::yields) {
            row.broken = true;
            row.closed = row.offset[0];
            row.released = 0.5 * row.borne.cwiseAbs2().cwiseQuotient(stiffness.cwiseMax(1e-300)).sum();
            return {Eigen::Vector2d::Zero(), row.borne.norm()};
        } else if constexpr (Law::breaks) {
            const auto [params, met] = params_against(network_, row.bond, {stiffness[0], stiffness[1]});
            const double radius = law_radius(network_, row.bond);
            History history = row.history;
            law::BondMotion<double> motion;
            motion.stretch = force[0] / met.normal;
            motion.shear = met.shear > 0.0 ? force[1] / met.shear : 0.0;
            motion.stretch += history.stretch;
            motion.shear += history.shear;
            Law::respond(params, radius, motion, history);
            row.broken = Law::broken(params, radius, motion, history);
            GivenWay given;
            given.moved = {history.stretch - row.history.stretch, history.shear - row.history.shear};
            given.beyond = std::hypot(met.normal * given.moved[0], met.shear * given.moved[1]);
            row.history = history;
            if (row.broken) row.closed = row.offset[0] + given.moved[0];
            return given;
        }
        return {};
    }

    /// A broken bond bears no pull; its faces touch when its offset has come back to what it was at breaking, and then
    /// rub.
    [[nodiscard]] GivenWay part(const Row& row, Eigen::Vector2d force, Eigen::Vector2d stiffness) const {
        Eigen::Vector2d moved;
        moved[0] = std::max(force[0] / stiffness[0], row.closed - row.offset[0]);
        const double pressed = std::max(0.0, stiffness[0] * moved[0] - force[0]);
        const double over = std::max(0.0, std::fabs(force[1]) - contact_.mu * pressed);
        moved[1] = stiffness[1] > 0.0 ? std::copysign(over / stiffness[1], force[1]) : 0.0;
        return {moved, stiffness.cwiseProduct(moved).norm()};
    }

    /// Takes the row's offset out of the measured forces.
    void add_offset(const Row& row) {
        if (row.offset == Eigen::Vector2d::Zero()) return;
        for (const std::size_t m : coupled_bonds(network_, row.bond)) {
            force_[m] -= offset_coupling(network_, m, row.bond) * row.offset;
        }
    }

    Bonds& bonds_;
    const state::Elements& elements_;
    Bonds network_; ///< as it was factorised
    law::Coulomb::Params contact_;
    std::vector<std::size_t> row_of_;
    std::vector<Row> rows_;
    std::vector<Row> kept_;
    std::vector<Eigen::Vector2d> force_; ///< of every bond as last measured, N
};

} // namespace demlua::step
