#include "engine/packing/pressing.hpp"

#include <cstddef>
#include <vector>

namespace demlua::packing {
namespace {

// Overlaps are in radii throughout. The figures below were found by trial on packs of 1 to 12,000 elements.
constexpr double final_overlap = 0.03; ///< the pack is done once no overlap exceeds this
constexpr int final_moves = 350;       ///< in one attempt at the end
constexpr int attempts = 60;           ///< with a squeeze and a shake before each but the first
constexpr double squeeze = 0.12;       ///< by which radii are too large for a while, as a share
constexpr double shake = 1.0;          ///< farthest that a shake throws a cluster along each axis
constexpr double fading = 0.95;        ///< strength of a squeeze and shake over that of the one before
constexpr double setback = 0.05;       ///< a shake that makes the largest overlap grow by more is undone
constexpr int squeeze_moves = 100;     ///< how long a squeeze lasts
constexpr double shrinking = 0.005;    ///< steps of the radius when looking for what does fit, as a share
constexpr int most_shrinks = 100;      ///< after which the search ends

} // namespace

double press(Growth& pack, double radius, std::uint64_t seed) {
    double left = pack.settle(final_overlap, final_moves);
    std::size_t torn = pack.torn_pairs();
    double strength = 1.0;
    for (std::uint64_t k = 1; k < attempts && left > final_overlap; ++k, strength *= fading) {
        const std::vector<Motion> before = pack.places();
        pack.grow_to((1.0 + strength * squeeze) * radius);
        pack.throw_about(strength * shake * radius, seed, k);
        pack.settle(0.0, squeeze_moves);
        pack.grow_to(radius);
        const double now = pack.settle(final_overlap, final_moves);
        const std::size_t torn_now = pack.torn_pairs();
        if (now > left + setback || torn_now > torn) {
            pack.put_back(before);
        } else {
            left = now;
            torn = torn_now;
        }
    }
    return left;
}

double fitting_share(Growth& pack) {
    const double wanted = pack.radius();
    for (int k = 0; k < most_shrinks && pack.settle(growing_overlap, final_moves) > growing_overlap; ++k) {
        pack.grow_to((1.0 - shrinking) * pack.radius());
    }
    return pack.radius() / wanted;
}

} // namespace demlua::packing
