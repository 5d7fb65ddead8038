#include "engine/packing/numbering.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace demlua::packing {

std::vector<std::size_t> order_by_bands(const std::vector<Vec2>& points, const Box& box, double band) {
    const bool wide = box.size().x >= box.size().y;
    struct Key {
        double band;
        double along;
    };
    std::vector<Key> keys;
    for (const Vec2 p : points) {
        const Vec2 q = p - box.lower;
        keys.push_back({std::floor((wide ? q.x : q.y) / band), wide ? q.y : q.x});
    }
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&keys](std::size_t a, std::size_t b) {
        return std::tie(keys[a].band, keys[a].along, a) < std::tie(keys[b].band, keys[b].along, b);
    });
    return order;
}

} // namespace demlua::packing
