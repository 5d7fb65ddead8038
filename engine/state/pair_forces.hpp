// Forces in pairs of elements, laid out for the loops that write and sum them.
#pragma once

#include "engine/base/number_column.hpp"
#include "engine/base/vec2.hpp"

#include <array>
#include <cstddef>

namespace demlua::state {

/// Of one pair: force on i, N (on j its opposite), and the moments on either, N m.
struct PairForce {
    Vec2 f;
    double moment_i = 0.0;
    double moment_j = 0.0;
};

/// Where the forces of pairs begin, for loops that read: in `quads` where there are any, else in columns.
struct ForceRows {
    NumberRows fx, fy, moment_i, moment_j;
    NumberRows quads;
};

/// The same for loops that write.
struct ForceTargets {
    NumberTargets fx, fy, moment_i, moment_j;
    NumberTargets quads;

    template <class Lane, class T>
    void store(std::size_t pair, const Vector2<T>& f, const T& on_i, const T& on_j) const {
        if (quads.wide != nullptr) {
            Lane::put_quads(quads.wide + 4 * pair, {f.x, f.y, on_i, on_j});
        } else if (quads.narrow != nullptr) {
            Lane::put_quads(quads.narrow + 4 * pair, {f.x, f.y, on_i, on_j});
        } else {
            fx.template store<Lane>(pair, f.x);
            fy.template store<Lane>(pair, f.y);
            moment_i.template store<Lane>(pair, on_i);
            moment_j.template store<Lane>(pair, on_j);
        }
    }
};

/// In columns where pairs that follow each other are of elements that follow each other: sums then read them straight. Else
/// the four numbers of a pair stand together (`quads`), and one that is looked up costs one line of memory.
class PairForces {
public:
    void lay_out_columns(std::size_t pairs) {
        for (NumberColumn* column : columns()) column->resize(pairs);
    }
    void lay_out_quads(std::size_t pairs) { quads_.resize(4 * pairs); }

    /// From now on the moment on j is that on i; of columns only.
    void share_moments() { moment_j_.clear(); }
    /// Rounds everything to single precision, now and whenever it is written.
    void keep_single() {
        for (NumberColumn* column : columns()) column->keep_single();
        quads_.keep_single();
    }

    [[nodiscard]] bool in_quads() const { return !quads_.empty(); }
    [[nodiscard]] PairForce at(std::size_t pair) const {
        if (in_quads()) {
            const std::size_t first = 4 * pair;
            return {{quads_[first], quads_[first + 1]}, quads_[first + 2], quads_[first + 3]};
        }
        return {{fx_[pair], fy_[pair]}, moment_i_[pair], moment_j_.empty() ? moment_i_[pair] : moment_j_[pair]};
    }
    void set(std::size_t pair, const PairForce& force) {
        const std::array<double, 4> numbers{force.f.x, force.f.y, force.moment_i, force.moment_j};
        for (std::size_t m = 0; m < numbers.size(); ++m) {
            if (in_quads())
                quads_.set(4 * pair + m, numbers[m]);
            else if (!columns()[m]->empty())
                columns()[m]->set(pair, numbers[m]);
        }
    }
    [[nodiscard]] ForceRows rows() const {
        const NumberColumn& on_j = moment_j_.empty() ? moment_i_ : moment_j_;
        return {fx_.rows(), fy_.rows(), moment_i_.rows(), on_j.rows(), quads_.rows()};
    }
    [[nodiscard]] ForceTargets targets() {
        NumberColumn& on_j = moment_j_.empty() ? moment_i_ : moment_j_;
        return {fx_.targets(), fy_.targets(), moment_i_.targets(), on_j.targets(), quads_.targets()};
    }

private:
    [[nodiscard]] std::array<NumberColumn*, 4> columns() { return {&fx_, &fy_, &moment_i_, &moment_j_}; }

    NumberColumn fx_, fy_, moment_i_, moment_j_;
    NumberColumn quads_;
};

} // namespace demlua::state
