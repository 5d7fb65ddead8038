// What a contact remembers from one search to the next, whatever the element touches.
#pragma once

#include "engine/state/contacts.hpp"

#include <cstddef>

namespace demlua::step {

struct ContactPast {
    state::ContactHistory contact;
    law::Rolling::History<double> rolling;
};

/// Of row `row` of a list of contacts with elements or with walls.
template <class List>
ContactPast past_of(const List& contacts, std::size_t row) {
    ContactPast past{contacts.history.at(row), {}};
    if (contacts.rolling.present()) past.rolling = contacts.rolling.history.at(row);
    return past;
}

/// Books what a contact that leaves its list has spent.
inline void book_spent(state::SpentInContacts& spent, const ContactPast& past) {
    spent.friction += past.contact.friction + past.rolling.friction;
    spent.damping += past.contact.damped + past.rolling.damped;
}

/// Energy that row `row`, a contact with spring and friction `params`, still stores, J.
template <class List>
double stored_in(const List& contacts, const law::Coulomb::Params& params, std::size_t row) {
    const ContactPast past = past_of(contacts, row);
    const double turned =
        contacts.rolling.present() ? law::Rolling::stored_energy(contacts.rolling.stiffness[row], past.rolling) : 0.0;
    return law::Coulomb::stored_energy(params, contacts.overlap[row], past.contact) + turned;
}

} // namespace demlua::step
