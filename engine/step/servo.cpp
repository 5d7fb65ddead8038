#include "engine/step/servo.hpp"

#include <algorithm>
#include <cmath>

namespace demlua::step {

double seek_force(state::Servo& servo, double side, double force, const Met& met, double time, double dt) {
    const double missing = servo.force.at(time) + side * force;
    double speed = missing > 0.0 ? servo.max_speed : 0.0;
    if (met.K > 0.0) {
        const double resistance = met.K * dt / servo.gain + 2.0 * met.C;
        speed = std::clamp(missing / resistance, -servo.max_speed, servo.max_speed);
    }
    servo.missed = met.K > 0.0 ? 0.0 : servo.missed + std::fabs(speed) * dt;
    return side * speed;
}

} // namespace demlua::step
