#include "engine/step/breaking.hpp"

namespace demlua::step {

state::ContactHistory inherited(const law::Coulomb::Params& contact, double overlap, double elastic_shear,
                                double slide) {
    state::ContactHistory history;
    if (overlap <= 0.0 || contact.Kt <= 0.0) return history;
    const double most = contact.mu * contact.Kn * overlap / contact.Kt;
    history.shear = clamped(elastic_shear, most) - slide;
    history.force = contact.Kt * history.shear;
    return history;
}

} // namespace demlua::step
