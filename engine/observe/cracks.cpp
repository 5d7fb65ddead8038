#include "engine/observe/cracks.hpp"

#include <algorithm>
#include <numeric>

namespace demlua::observe {

namespace {

/// Disjoint sets; the root of each is its lowest member, so that numbering follows the elements.
class Parts {
public:
    explicit Parts(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }

    std::size_t root(std::size_t k) {
        while (parent_[k] != k) {
            parent_[k] = parent_[parent_[k]];
            k = parent_[k];
        }
        return k;
    }

    void join(std::size_t a, std::size_t b) {
        a = root(a);
        b = root(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::size_t> parent_;
};

/// Length of crack that one broken bond stands for, m.
template <class Law>
double crack_across(const state::BondSet<Law>& bonds, std::size_t k) {
    return 2.0 * bonds.radius[k];
}

template <class Law>
double crack_across(const state::FacetSet<Law>& bonds, std::size_t k) {
    return bonds.area[k];
}

template <class Sum, class Of>
Sum over_bond_sets(const state::State& state, const Of& of) {
    Sum sum{};
    for (const state::AnyBondSet& any : state.bond_sets) {
        sum += std::visit([&](const auto& bonds) -> Sum { return of(bonds); }, any);
    }
    return sum;
}

} // namespace

std::size_t bond_count(const state::State& state) {
    return over_bond_sets<std::size_t>(state, [](const auto& bonds) { return bonds.size(); });
}

std::size_t broken_bond_count(const state::State& state) {
    return over_bond_sets<std::size_t>(state, [](const auto& bonds) { return bonds.broken_count; });
}

double crack_length_of(const state::State& state) {
    return over_bond_sets<double>(state, [](const auto& bonds) {
        double length = 0.0;
        for (std::size_t k = 0; k < bonds.size(); ++k) {
            if (bonds.is_broken(k)) length += crack_across(bonds, k);
        }
        return length;
    });
}

std::vector<std::int32_t> fragment_of_elements(const state::State& state) {
    Parts parts(state.elements.size());
    for (const state::AnyBondSet& any : state.bond_sets) {
        std::visit(
            [&](const auto& bonds) {
                for (std::size_t k = 0; k < bonds.size(); ++k) {
                    if (!bonds.is_broken(k)) parts.join(bonds.i[k], bonds.j[k]);
                }
            },
            any);
    }
    for (const state::RigidBody& rigid : state.rigid_bodies) {
        const state::Body& body = state.bodies[rigid.body];
        for (std::size_t k = body.first; k < body.last; ++k) parts.join(body.first, k);
    }
    std::vector<std::int32_t> fragment(state.elements.size());
    std::int32_t next = 0;
    for (std::size_t k = 0; k < fragment.size(); ++k) {
        const std::size_t root = parts.root(k);
        fragment[k] = root == k ? next++ : fragment[root];
    }
    return fragment;
}

std::size_t fragment_count(const std::vector<std::int32_t>& fragment) {
    return fragment.empty() ? 0 : static_cast<std::size_t>(*std::max_element(fragment.begin(), fragment.end())) + 1;
}

} // namespace demlua::observe
