#include "engine/step/breaking.hpp"

namespace demlua::step {

state::ContactHistory inherited(const law::Coulomb::Params& contact, double overlap, double shear_force, double slide) {
    state::ContactHistory history;
    if (overlap <= 0.0 || contact.Kt <= 0.0) return history;
    history.shear = clamped(shear_force, contact.mu * contact.Kn * overlap) / contact.Kt - slide;
    history.force = contact.Kt * history.shear;
    return history;
}

} // namespace demlua::step
