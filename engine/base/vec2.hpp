// Plane vectors over any number type: double in set-up code, a lane of doubles in the loops.
#pragma once

#include "engine/base/lanes.hpp"

#include <cmath>

namespace demlua {

template <class T>
struct Vector2 {
    T x{};
    T y{};

    friend constexpr Vector2 operator+(Vector2 a, Vector2 b) { return {a.x + b.x, a.y + b.y}; }
    friend constexpr Vector2 operator-(Vector2 a, Vector2 b) { return {a.x - b.x, a.y - b.y}; }
    friend constexpr Vector2 operator-(Vector2 a) { return {-a.x, -a.y}; }
    friend constexpr Vector2 operator*(T s, Vector2 a) { return {s * a.x, s * a.y}; }
    friend constexpr Vector2 operator*(Vector2 a, T s) { return {s * a.x, s * a.y}; }
    friend constexpr Vector2 operator/(Vector2 a, T s) { return {a.x / s, a.y / s}; }
    constexpr Vector2& operator+=(Vector2 b) { return *this = *this + b; }
    constexpr Vector2& operator-=(Vector2 b) { return *this = *this - b; }
    friend constexpr bool operator==(Vector2 a, Vector2 b) { return a.x == b.x && a.y == b.y; }
};

using Vec2 = Vector2<double>;

template <class T>
constexpr T dot(Vector2<T> a, Vector2<T> b) {
    return a.x * b.x + a.y * b.y;
}

/// Out-of-plane component of a x b; positive when b lies counter-clockwise of a.
template <class T>
constexpr T cross(Vector2<T> a, Vector2<T> b) {
    return a.x * b.y - a.y * b.x;
}

/// a turned by +90 degrees.
template <class T>
constexpr Vector2<T> turned_left(Vector2<T> a) {
    return {-a.y, a.x};
}

template <class T>
T norm(Vector2<T> a) {
    return square_root(dot(a, a));
}

/// a turned counter-clockwise by `angle` (rad).
inline Vec2 turned(Vec2 a, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * a.x - s * a.y, s * a.x + c * a.y};
}

/// Axis-aligned box, metres; empty when lower exceeds upper.
struct Box {
    Vec2 lower;
    Vec2 upper;

    [[nodiscard]] constexpr Vec2 size() const { return upper - lower; }
    [[nodiscard]] constexpr bool empty() const { return lower.x > upper.x || lower.y > upper.y; }
};

} // namespace demlua
