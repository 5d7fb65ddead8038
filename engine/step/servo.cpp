#include "engine/step/servo.hpp"

#include <algorithm>
#include <cmath>

namespace demlua::step {

namespace {

constexpr double memory =
    10.0; // so that on a bed of ten layers, a tenth as stiff as its contacts, no overshoot is left

} // namespace

double seek_force(state::Servo& servo, double side, double force, const Met& met, double time, double dt) {
    const double missing = servo.force.at(time) + side * force;
    double speed = missing > 0.0 ? servo.max_speed : 0.0;
    if (met.K > 0.0) {
        const double R = met.K * dt / servo.gain + 2.0 * met.C;
        const double M = memory * R * R / met.K;
        servo.kept = std::clamp(servo.kept + missing * dt / M, -servo.max_speed, servo.max_speed);
        speed = std::clamp(missing / R + servo.kept, -servo.max_speed, servo.max_speed);
    } else {
        servo.kept = 0.0;
    }
    servo.missed = met.K > 0.0 ? 0.0 : servo.missed + std::fabs(speed) * dt;
    return side * speed;
}

} // namespace demlua::step
