#include "engine/step/contact_forces.hpp"

#include "engine/base/lanes.hpp"

namespace demlua::step {

namespace {

void release(state::Contacts& contacts, std::size_t c) {
    contacts.fx[c] = contacts.fy[c] = contacts.moment_i[c] = contacts.moment_j[c] = 0.0;
}

bool at_rest(const state::ContactHistory& history) { return history.force == 0.0 && history.damping == 0.0; }

/// The couple against rolling; zero the instant the pair parts.
double rolling_moment(state::Contacts& contacts, const state::Elements& elements, std::size_t c, double pressure,
                      double dt) {
    state::RollingContacts& rolling = contacts.rolling;
    law::Rolling::History<double> history = rolling.history.at(c);
    const double cap = contacts.rules[contacts.rule[c]].rolling_friction * rolling.radius[c] * pressure;
    const double moment = law::Rolling::respond<double>(
        {rolling.stiffness[c], rolling.dashpot[c], cap, elements.spin[contacts.j[c]] - elements.spin[contacts.i[c]]},
        dt, history);
    rolling.history.store(c, history);
    return moment;
}

template <bool rolls, class Shortest>
void forces_of(state::Contacts& contacts, const state::Elements& elements, const Shortest& shortest, double dt,
               Share part) {
    for (std::size_t c = part.begin; c < part.end; ++c) {
        const std::size_t i = contacts.i[c];
        const std::size_t j = contacts.j[c];
        const Vec2 span = shortest(elements.position(j) - elements.position(i));
        const double d = norm(span);
        const double overlap = contacts.reference[c] - d;
        contacts.overlap[c] = overlap;
        state::ContactHistory history = contacts.history.at(c);
        if (overlap <= 0.0 && at_rest(history)) {
            release(contacts, c);
            if constexpr (rolls) rolling_moment(contacts, elements, c, 0.0, dt);
            continue;
        }
        const Vec2 normal = span / d;
        const Vec2 tangent = turned_left(normal);
        const Vec2 v = elements.velocity(j) - elements.velocity(i);
        const double a_i = d * elements.radius[i] / (elements.radius[i] + elements.radius[j]);
        const double a_j = d - a_i;
        const law::Coulomb::Input<double> in{overlap, -dot(v, normal),
                                             dot(v, tangent) - a_i * elements.spin[i] - a_j * elements.spin[j],
                                             contacts.Cn[c], contacts.Ct[c]};
        const auto force = law::Coulomb::respond(contacts.rules[contacts.rule[c]].params, in, dt, history);
        contacts.history.store(c, history);
        const Vec2 f = force.shear * tangent - force.pressure * normal;
        contacts.fx[c] = f.x;
        contacts.fy[c] = f.y;
        contacts.moment_i[c] = force.shear * a_i;
        contacts.moment_j[c] = force.shear * a_j;
        if constexpr (rolls) {
            const double couple = rolling_moment(contacts, elements, c, force.pressure, dt);
            contacts.moment_i[c] += couple;
            contacts.moment_j[c] -= couple;
        }
    }
}

template <class Shortest>
void forces_along(state::Contacts& contacts, const state::Elements& elements, const Shortest& shortest, double dt,
                  Share part) {
    contacts.rolls ? forces_of<true>(contacts, elements, shortest, dt, part)
                   : forces_of<false>(contacts, elements, shortest, dt, part);
}

} // namespace

void contact_forces(state::Contacts& contacts, const state::Elements& elements, Period period, double dt, Share part) {
    if (period.repeats()) {
        forces_along(
            contacts, elements, [&](Vec2 span) { return period.shortest(span); }, dt, part);
    } else {
        forces_along(
            contacts, elements, [](Vec2 span) { return span; }, dt, part);
    }
}

} // namespace demlua::step
