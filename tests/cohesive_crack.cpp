#include "tests/cohesive_crack.hpp"

#include "tests/finite_elements.hpp"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>

namespace demlua::test {

namespace {

constexpr double fracture_energy = std::numbers::pi;
constexpr double last_softening_opening = 2.0 * fracture_energy;
constexpr double last_plateau_opening = fracture_energy;

// ---- the half body ----

/// Places from 0 to `total`: cells of the size `cell` as far as `even_until`, growing from there to `largest`.
std::vector<double> graded(double total, double cell, double even_until, double growth, double largest) {
    std::vector<double> places{0.0};
    double size = cell;
    while (places.back() < total) {
        if (places.back() > even_until) {
            size = std::min(size * growth, largest);
        }
        places.push_back(places.back() + size);
    }
    const double scale = total / places.back();
    for (double& place : places) {
        place *= scale;
    }
    return places;
}

void append(std::vector<double>& places, const std::vector<double>& further) {
    const double from = places.back();
    for (std::size_t k = 1; k < further.size(); ++k) {
        places.push_back(from + further[k]);
    }
}

std::vector<double> columns(const NotchedBody& body, const LigamentMesh& mesh) {
    const double largest = body.width / 12.0;
    std::vector<double> places{0.0};
    if (body.notch > 0.0) {
        places = graded(body.notch, mesh.cell, 0.0, mesh.growth, largest);
        std::reverse(places.begin(), places.end());
        for (double& place : places) {
            place = body.notch - place;
        }
    }
    append(places, graded(body.width - body.notch, mesh.cell, mesh.reach, mesh.growth, largest));
    return places;
}

std::vector<double> rows(const NotchedBody& body, const LigamentMesh& mesh) {
    const double largest = body.width / 12.0;
    const bool bent = body.load == NotchedBody::Load::bending;
    const double first = bent ? 2.0 * body.width : body.half_height;
    std::vector<double> places = graded(first, mesh.cell, 2.0 * mesh.cell, mesh.growth, largest);
    if (bent) {
        append(places, graded(body.half_height - first, largest, 0.0, 1.0, largest));
    }
    return places;
}

fe::Mesh upper_half(const NotchedBody& body, const LigamentMesh& mesh) {
    const auto unit = [](std::vector<double> places) {
        const double length = places.back();
        for (double& place : places) {
            place /= length;
        }
        return places;
    };
    return fe::block(unit(columns(body, mesh)), unit(rows(body, mesh)), [&](double s, double t) {
        return Vec2{s * body.width, t * body.half_height};
    });
}

fe::Supports supports(const NotchedBody& body, const fe::Mesh& half, double last_fine) {
    fe::Supports held(half);
    held.hold_y([=](Vec2 at) { return std::fabs(at.y) < fe::touching && at.x > last_fine + fe::touching; });
    if (body.load == NotchedBody::Load::bending) {
        held.hold_x(fe::at_point({0.0, 2.0 * body.width}));
    } else if (body.mirror_at_start) {
        held.hold_x(fe::at_x(0.0));
    } else if (body.mirror_at_end) {
        held.hold_x(fe::at_x(body.width));
    } else {
        held.hold_x(fe::at_point({body.width, 0.0}));
    }
    return held;
}

fe::Field unit_load(const NotchedBody& body, const fe::Mesh& half) {
    if (body.load == NotchedBody::Load::tension) {
        return fe::forces(half, fe::boundary(half, fe::at_y(body.half_height)), 1.0, fe::uniform({0.0, 1.0}));
    }
    // A moment width^2 / 6 under the middle of a span of 4 width; this half takes half the force.
    fe::Field load = fe::Field::Zero(static_cast<Eigen::Index>(2 * half.nodes.size()));
    load[2 * fe::nearest_node(half, {body.width, 0.0})] = -body.width / 12.0;
    return load;
}

/// Nodes of the fine part of the ligament, by x.
std::vector<int> fine_nodes(const NotchedBody& body, const fe::Mesh& half, double last_fine) {
    std::vector<int> nodes;
    for (std::size_t k = 0; k < half.nodes.size(); ++k) {
        const Vec2 at = half.nodes[k];
        if (std::fabs(at.y) < fe::touching && at.x > body.notch - fe::touching && at.x < last_fine + fe::touching) {
            nodes.push_back(static_cast<int>(k));
        }
    }
    std::sort(nodes.begin(), nodes.end(), [&](int a, int b) {
        return half.nodes[static_cast<std::size_t>(a)].x < half.nodes[static_cast<std::size_t>(b)].x;
    });
    return nodes;
}

/// A matrix over the components that are kept and those that are condensed.
struct Parts {
    Eigen::SparseMatrix<double> inner;
    Eigen::SparseMatrix<double> mixed; // inner rows, kept columns
    Eigen::MatrixXd kept;
};

/// `place` of a component: its number among the kept if below `kept`, else `kept` plus that among the inner.
Parts divide(const Eigen::SparseMatrix<double>& matrix, const std::vector<int>& place, int kept) {
    const int inner = static_cast<int>(matrix.rows()) - kept;
    Parts parts{{inner, inner}, {inner, kept}, Eigen::MatrixXd::Zero(kept, kept)};
    std::vector<Eigen::Triplet<double>> in;
    std::vector<Eigen::Triplet<double>> mixed;
    for (int column = 0; column < matrix.outerSize(); ++column) {
        const int j = place[static_cast<std::size_t>(column)];
        for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, column); entry; ++entry) {
            const int i = place[static_cast<std::size_t>(entry.row())];
            if (i >= kept && j >= kept) {
                in.emplace_back(i - kept, j - kept, entry.value());
            } else if (i >= kept) {
                mixed.emplace_back(i - kept, j, entry.value());
            } else if (j < kept) {
                parts.kept(i, j) = entry.value();
            }
        }
    }
    parts.inner.setFromTriplets(in.begin(), in.end());
    parts.mixed.setFromTriplets(mixed.begin(), mixed.end());
    return parts;
}

// ---- the ligament ----

using Cell3 = std::array<double, 3>;
constexpr Cell3 gauss_places{-0.774596669241483377, 0.0, 0.774596669241483377};
constexpr Cell3 gauss_weights{5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};

Eigen::Vector3d parabolas(double x) { return {0.5 * x * (x - 1.0), 1.0 - x * x, 0.5 * x * (x + 1.0)}; }

struct Traction {
    double value;
    double slope; // over the opening
};

Traction traction(Softening shape, double opening) {
    if (shape == Softening::plateau || opening < 0.0) {
        return {1.0, 0.0};
    }
    const double left = 1.0 - opening / last_softening_opening;
    return left > 0.0 ? Traction{left, -1.0 / last_softening_opening} : Traction{0.0, 0.0};
}

/// Forces that the ligament opposes to its half-openings v, with their slopes.
void add_cohesion(const Ligament& ligament, Softening shape, const Eigen::VectorXd& v, Eigen::VectorXd& force,
                  Eigen::MatrixXd& slope) {
    const Eigen::Index rows = force.size();
    for (Eigen::Index first = 0; first + 2 < v.size() && first < rows; first += 2) {
        const double half = 0.5 * (ligament.x[static_cast<std::size_t>(first + 2)] - ligament.x[static_cast<std::size_t>(first)]);
        for (std::size_t g = 0; g < 3; ++g) {
            const Eigen::Vector3d N = parabolas(gauss_places[g]);
            const Traction q = traction(shape, 2.0 * N.dot(v.segment<3>(first)));
            const double length = half * gauss_weights[g];
            for (Eigen::Index i = 0; i < 3 && first + i < rows; ++i) {
                force[first + i] += length * N[i] * q.value;
                for (Eigen::Index j = 0; j < 3 && first + j < slope.cols(); ++j) {
                    slope(first + i, first + j) += length * N[i] * N[j] * 2.0 * q.slope;
                }
            }
        }
    }
}

/// Half-openings of all nodes and the load with the zone's tip at node `tip`, by Newton's method from the values given.
void balance(const Ligament& ligament, Softening shape, Eigen::Index tip, Eigen::VectorXd& v, double& load) {
    const Eigen::Index rows = tip + 1;
    const auto stiffness = ligament.stiffness.topLeftCorner(rows, tip);
    const auto pull = ligament.pull.head(rows);
    for (int turn = 0; turn < 50; ++turn) {
        Eigen::VectorXd cohesion = Eigen::VectorXd::Zero(rows);
        Eigen::MatrixXd tangent(rows, rows);
        tangent.leftCols(tip) = stiffness;
        tangent.col(tip) = -pull;
        Eigen::MatrixXd slope = Eigen::MatrixXd::Zero(rows, tip);
        add_cohesion(ligament, shape, v, cohesion, slope);
        tangent.leftCols(tip) += slope;
        const Eigen::VectorXd change = tangent.partialPivLu().solve(load * pull - stiffness * v.head(tip) - cohesion);
        v.head(tip) += change.head(tip);
        load += change[tip];
        if (change.head(tip).lpNorm<Eigen::Infinity>() < 1e-10 && std::fabs(change[tip]) < 1e-11) {
            return;
        }
    }
    throw std::runtime_error("cohesive crack: no balance");
}

/// The place at which the traction sets in.
double zone_start(const Ligament& ligament, Softening shape, const Eigen::VectorXd& v) {
    const double last = shape == Softening::linear ? last_softening_opening : last_plateau_opening;
    std::size_t k = 0;
    while (2.0 * v[static_cast<Eigen::Index>(k)] > last) {
        ++k;
    }
    if (k == 0) {
        return ligament.x.front();
    }
    const double before = 2.0 * v[static_cast<Eigen::Index>(k - 1)];
    const double after = 2.0 * v[static_cast<Eigen::Index>(k)];
    return ligament.x[k] - (ligament.x[k] - ligament.x[k - 1]) * (last - after) / (before - after);
}

Growth between(const Growth& a, const Growth& b, double share) {
    const auto mean = [share](double from, double to) { return from + share * (to - from); };
    return {mean(a.tip, b.tip), mean(a.load, b.load), mean(a.opening, b.opening), mean(a.zone_from, b.zone_from)};
}

/// Energy in half the body under a unit load, the nodes before `open` free, less that with all closed.
double released(const Ligament& ligament, Eigen::Index open) {
    if (open == 0) {
        return 0.0;
    }
    const Eigen::VectorXd pull = ligament.pull.head(open);
    return 0.5 * pull.dot(ligament.stiffness.topLeftCorner(open, open).llt().solve(pull));
}

} // namespace

Ligament condense(const NotchedBody& body, const LigamentMesh& mesh) {
    const fe::Mesh half = upper_half(body, mesh);
    const std::vector<double> stations = columns(body, mesh);
    const double wanted = std::min(body.width, body.notch + mesh.reach);
    const double last_fine = *std::lower_bound(stations.begin(), stations.end() - 1, wanted);

    const fe::System system = fe::assemble(half, {.modulus = 1.0, .poisson = body.poisson}, supports(body, half, last_fine));
    const std::vector<int> nodes = fine_nodes(body, half, last_fine);
    const int kept = static_cast<int>(nodes.size());
    std::vector<int> place(static_cast<std::size_t>(system.stiffness.rows()), -1);
    for (int k = 0; k < kept; ++k) {
        const int component = 2 * nodes[static_cast<std::size_t>(k)] + 1;
        place[static_cast<std::size_t>(system.row[static_cast<std::size_t>(component)])] = k;
    }
    int next = kept;
    for (int& number : place) {
        if (number < 0) {
            number = next++;
        }
    }

    const fe::Field load = unit_load(body, half);
    Eigen::VectorXd inner_load = Eigen::VectorXd::Zero(system.stiffness.rows() - kept);
    for (std::size_t k = 0; k < system.row.size(); ++k) {
        const int number = system.row[k] < 0 ? -1 : place[static_cast<std::size_t>(system.row[k])];
        if (number >= kept) {
            inner_load[number - kept] = load[static_cast<Eigen::Index>(k)];
        }
    }

    const Parts parts = divide(system.stiffness, place, kept);
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(parts.inner);
    if (factors.info() != Eigen::Success) {
        throw std::runtime_error("cohesive crack: the supports leave the body movable");
    }
    Ligament ligament;
    for (const int node : nodes) {
        ligament.x.push_back(half.nodes[static_cast<std::size_t>(node)].x);
    }
    const Eigen::MatrixXd follows = factors.solve(Eigen::MatrixXd(parts.mixed));
    ligament.stiffness = parts.kept - parts.mixed.transpose() * follows;
    ligament.pull = -(follows.transpose() * inner_load);
    return ligament;
}

std::vector<Growth> grow(const Ligament& ligament, Softening shape, double stop) {
    const auto nodes = static_cast<Eigen::Index>(ligament.x.size());
    Eigen::VectorXd v = Eigen::VectorXd::Zero(nodes);
    double load = 0.0;
    double highest = 0.0;
    std::vector<Growth> states;
    for (Eigen::Index tip = 0; tip < nodes; tip += 2) {
        balance(ligament, shape, tip, v, load);
        states.push_back({ligament.x[static_cast<std::size_t>(tip)], load, 2.0 * v[0], zone_start(ligament, shape, v)});
        highest = std::max(highest, load);
        const bool past = shape == Softening::linear ? load < stop * highest : 2.0 * v[0] > last_plateau_opening;
        if (past) {
            return states;
        }
    }
    throw std::runtime_error("cohesive crack: the zone outgrows the fine part of the ligament");
}

Growth peak(const std::vector<Growth>& states, Softening shape) {
    if (shape == Softening::plateau) {
        const Growth& before = states[states.size() - 2];
        const Growth& after = states.back();
        return between(before, after, (last_plateau_opening - before.opening) / (after.opening - before.opening));
    }
    const auto highest = std::max_element(states.begin(), states.end(),
                                          [](const Growth& a, const Growth& b) { return a.load < b.load; });
    if (highest == states.begin()) {
        return *highest;
    }
    // The parabola through three equally spaced tips.
    const double before = std::prev(highest)->load;
    const double after = std::next(highest)->load;
    const double bend = before - 2.0 * highest->load + after;
    const double share = bend < 0.0 ? 0.5 * (before - after) / bend : 0.0;
    Growth top = share < 0.0 ? between(*highest, *std::prev(highest), -share) : between(*highest, *std::next(highest), share);
    top.load = highest->load - 0.5 * bend * share * share;
    return top;
}

double stress_intensity(const Ligament& ligament, int corner) {
    const auto at = static_cast<std::size_t>(corner);
    const double length = ligament.x[at + 2] - ligament.x[at - 2];
    return std::sqrt(2.0 * (released(ligament, corner + 2) - released(ligament, corner - 2)) / length);
}

} // namespace demlua::test
