// What a contact remembers from one search to the next, whatever the element touches.
#pragma once

#include "engine/state/contacts.hpp"

#include <cstddef>

namespace demlua::step {

struct ContactPast {
    state::ContactHistory contact;
    law::Rolling::History<double> rolling;
    law::Spent<double> spent; ///< as far as the row keeps it
    law::Spent<double> spent_in_rolling;
};

/// Of row `row` of a list of contacts with elements or with walls; all but `spent`.
template <class List>
ContactPast past_of(const List& contacts, std::size_t row) {
    ContactPast past{contacts.history.at(row), {}, {}, {}};
    if (contacts.rolling.present()) {
        past.rolling = contacts.rolling.history.at(row);
        past.spent_in_rolling = contacts.rolling.spent.at(row);
    }
    return past;
}

/// Energy that a contact with spring and friction `params` and turning stiffness `kr` still stores, J.
inline double stored_in(const ContactPast& past, const law::Coulomb::Params& params, double overlap, double kr) {
    return law::Coulomb::stored_energy(params, overlap, past.contact) + law::Rolling::stored_energy(kr, past.rolling);
}

} // namespace demlua::step
