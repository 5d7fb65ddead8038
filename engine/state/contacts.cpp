#include "engine/state/contacts.hpp"

#include <cmath>

namespace demlua::state {

void RollingContacts::push_back(double reduced_radius, double Kt, double damping_fraction, double reduced_inertia,
                                const law::Rolling::History<double>& past, const law::Spent<double>& past_spent) {
    const double kr = Kt * reduced_radius * reduced_radius;
    stiffness.push_back(kr);
    dashpot.push_back(2.0 * damping_fraction * std::sqrt(kr * reduced_inertia));
    radius.push_back(reduced_radius);
    history.resize(stiffness.size());
    history.store(stiffness.size() - 1, past);
    spent.push_back(past_spent);
}

} // namespace demlua::state
