#include "tests/finite_element_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

namespace demlua::fe {

namespace {

/// The four sides of a cell, counter-clockwise: local numbers of their nodes.
constexpr std::array<std::array<std::size_t, 3>, 4> sides{{{0, 1, 2}, {2, 5, 8}, {8, 7, 6}, {6, 3, 0}}};

/// Numbers nodes, giving the old number to a place already seen.
class Joiner {
public:
    explicit Joiner(std::vector<Vec2>& nodes) : m_nodes(nodes) {}

    int number(Vec2 at) {
        const BoxNumber box{std::llround(at.x / (2.0 * touching)), std::llround(at.y / (2.0 * touching))};
        for (std::int64_t i = box.first - 1; i <= box.first + 1; ++i) {
            for (std::int64_t j = box.second - 1; j <= box.second + 1; ++j) {
                const auto found = m_seen.find({i, j});
                if (found != m_seen.end() && norm(m_nodes[static_cast<std::size_t>(found->second)] - at) <= touching) {
                    return found->second;
                }
            }
        }
        const int fresh = static_cast<int>(m_nodes.size());
        m_nodes.push_back(at);
        m_seen.emplace(box, fresh);
        return fresh;
    }

private:
    using BoxNumber = std::pair<std::int64_t, std::int64_t>;

    std::vector<Vec2>& m_nodes;
    std::map<BoxNumber, int> m_seen;
};

Stations with_middles(const Stations& stations) {
    Stations all{stations.front()};
    for (std::size_t k = 1; k < stations.size(); ++k) {
        all.push_back(0.5 * (stations[k - 1] + stations[k]));
        all.push_back(stations[k]);
    }
    return all;
}

} // namespace

Place at_x(double x) {
    return [x](Vec2 at) { return std::fabs(at.x - x) < touching; };
}

Place at_y(double y) {
    return [y](Vec2 at) { return std::fabs(at.y - y) < touching; };
}

Place at_point(Vec2 point) {
    return [point](Vec2 at) { return norm(at - point) < touching; };
}

Stations even(int cells) { return small_at_start(cells, 1.0); }

Stations small_at_start(int cells, double power) {
    Stations stations;
    for (int k = 0; k <= cells; ++k) {
        stations.push_back(std::pow(static_cast<double>(k) / cells, power));
    }
    return stations;
}

Stations small_at_end(int cells, double power) {
    Stations stations = small_at_start(cells, power);
    std::reverse(stations.begin(), stations.end());
    for (double& station : stations) {
        station = 1.0 - station;
    }
    return stations;
}

Stations small_at_ends(int cells, double power) {
    Stations stations;
    for (const double station : small_at_start(cells / 2, power)) {
        stations.push_back(0.5 * station);
    }
    for (const double station : small_at_end(cells / 2, power)) {
        if (station > 0.0) {
            stations.push_back(0.5 + 0.5 * station);
        }
    }
    return stations;
}

Mesh block(const Stations& s, const Stations& t, const Mapping& mapping) {
    Mesh mesh;
    const Stations all_s = with_middles(s);
    const Stations all_t = with_middles(t);
    for (const double v : all_t) {
        for (const double u : all_s) {
            mesh.nodes.push_back(mapping(u, v));
        }
    }
    const int columns = static_cast<int>(s.size()) - 1;
    const int rows = static_cast<int>(t.size()) - 1;
    const int wide = static_cast<int>(all_s.size());
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            Cell cell{};
            for (int k = 0; k < 9; ++k) {
                cell[static_cast<std::size_t>(k)] = (2 * row + k / 3) * wide + 2 * column + k % 3;
            }
            mesh.cells.push_back(cell);
        }
    }
    return mesh;
}

Mesh joined(const std::vector<Mesh>& parts) {
    Mesh whole;
    Joiner joiner(whole.nodes);
    for (const Mesh& part : parts) {
        std::vector<int> number;
        number.reserve(part.nodes.size());
        for (const Vec2 at : part.nodes) {
            number.push_back(joiner.number(at));
        }
        for (Cell cell : part.cells) {
            for (int& node : cell) {
                node = number[static_cast<std::size_t>(node)];
            }
            whole.cells.push_back(cell);
        }
    }
    return whole;
}

std::vector<Edge> boundary(const Mesh& mesh, const Place& where) {
    // The middle node of a side belongs to one cell on the boundary and to two inside.
    std::vector<int> cells_at(mesh.nodes.size(), 0);
    for (const Cell& cell : mesh.cells) {
        for (const int node : cell) {
            ++cells_at[static_cast<std::size_t>(node)];
        }
    }
    std::vector<Edge> edges;
    for (const Cell& cell : mesh.cells) {
        for (const auto& side : sides) {
            const Edge edge{cell[side[0]], cell[side[1]], cell[side[2]]};
            const bool inside = std::all_of(
                edge.begin(), edge.end(), [&](int node) { return where(mesh.nodes[static_cast<std::size_t>(node)]); });
            if (inside && cells_at[static_cast<std::size_t>(edge[1])] == 1) {
                edges.push_back(edge);
            }
        }
    }
    return edges;
}

int nearest_node(const Mesh& mesh, Vec2 place) {
    const auto found = std::min_element(mesh.nodes.begin(), mesh.nodes.end(),
                                        [&](Vec2 a, Vec2 b) { return norm(a - place) < norm(b - place); });
    return static_cast<int>(found - mesh.nodes.begin());
}

} // namespace demlua::fe
