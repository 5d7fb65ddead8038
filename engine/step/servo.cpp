#include "engine/step/servo.hpp"

#include <algorithm>
#include <cmath>

namespace demlua::step {

double seek_force(state::Servo& servo, double side, double force, double K, double time, double dt) {
    const double missing = servo.force.at(time) + side * force;
    double speed = missing > 0.0 ? servo.max_speed : 0.0;
    if (K > 0.0) speed = std::clamp(servo.gain * missing / (K * dt), -servo.max_speed, servo.max_speed);
    servo.missed = K > 0.0 ? 0.0 : servo.missed + std::fabs(speed) * dt;
    return side * speed;
}

} // namespace demlua::step
