#include "engine/observe/hash.hpp"

#include <cstddef>
#include <cstring>

namespace demlua::observe {

namespace {

struct Fingerprint {
    std::uint64_t value = 14695981039346656037ULL;

    template <class T>
    void add(const T& entry) {
        unsigned char bytes[sizeof(T)];
        std::memcpy(&bytes[0], &entry, sizeof(T));
        for (const unsigned char byte : bytes) value = (value ^ byte) * 1099511628211ULL;
    }
    template <class T>
    void add(const Column<T>& column) {
        for (const T& entry : column) add(entry);
    }
};

} // namespace

std::uint64_t hash_of(const state::State& state) {
    const state::Elements& elements = state.elements;
    Fingerprint print;
    for (const Column<double>* column :
         {&elements.ux, &elements.uy, &elements.rotation, &elements.vx, &elements.vy, &elements.spin}) {
        print.add(*column);
    }
    for (const state::AnyBondSet& any : state.bond_sets) {
        std::visit([&](const auto& bonds) { print.add(bonds.broken); }, any);
    }
    for (const state::Wall& wall : state.walls) {
        for (const Vec2 each : {wall.offset, wall.velocity}) {
            print.add(each.x);
            print.add(each.y);
        }
        print.add(wall.rotation);
        print.add(wall.spin);
    }
    return print.value;
}

} // namespace demlua::observe
