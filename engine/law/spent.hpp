// What a contact takes out of the motion for good.
#pragma once

#include <array>

namespace demlua::law {

template <class T>
struct Spent {
    T friction{}; ///< by slipping, or rolling on, J
    T damped{};   ///< by dashpots, J
    static constexpr std::array<T Spent::*, 2> members{&Spent::friction, &Spent::damped};

    Spent& operator+=(const Spent& other) {
        friction += other.friction;
        damped += other.damped;
        return *this;
    }
};

} // namespace demlua::law
