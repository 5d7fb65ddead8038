// Half a notched body, condensed to the nodes ahead of its notch.
#include "tests/cohesive_crack.hpp"

#include "tests/finite_elements.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace demlua::test {

namespace {

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

/// A new place for every row of a system: the vertical components of `kept` first, the others after them.
std::vector<int> places_of_rows(const fe::System& system, const std::vector<int>& kept) {
    std::vector<int> place(static_cast<std::size_t>(system.stiffness.rows()), -1);
    int next = 0;
    for (const int node : kept) {
        const int row = system.row[2 * static_cast<std::size_t>(node) + 1];
        place[static_cast<std::size_t>(row)] = next++;
    }
    for (int& number : place) {
        if (number < 0) {
            number = next++;
        }
    }
    return place;
}

/// The components of a field that are free and not kept.
Eigen::VectorXd inner_part(const fe::System& system, const std::vector<int>& place, int kept, const fe::Field& field) {
    Eigen::VectorXd part = Eigen::VectorXd::Zero(system.stiffness.rows() - kept);
    for (std::size_t k = 0; k < system.row.size(); ++k) {
        const int number = system.row[k] < 0 ? -1 : place[static_cast<std::size_t>(system.row[k])];
        if (number >= kept) {
            part[number - kept] = field[static_cast<Eigen::Index>(k)];
        }
    }
    return part;
}

/// A matrix over the components that are kept and those that are condensed.
struct Parts {
    Eigen::SparseMatrix<double> inner;
    Eigen::SparseMatrix<double> mixed; // inner rows, kept columns
    Eigen::MatrixXd kept;
};

/// Divides a matrix whose rows go to `place`, the first `kept` of which are kept.
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

} // namespace

Ligament condense(const NotchedBody& body, const LigamentMesh& mesh) {
    const fe::Mesh half = upper_half(body, mesh);
    const std::vector<double> stations = columns(body, mesh);
    const double wanted = std::min(body.width, body.notch + mesh.reach);
    const double last_fine = *std::lower_bound(stations.begin(), stations.end() - 1, wanted);

    const fe::System system =
        fe::assemble(half, {.modulus = 1.0, .poisson = body.poisson}, supports(body, half, last_fine));
    const std::vector<int> nodes = fine_nodes(body, half, last_fine);
    const int kept = static_cast<int>(nodes.size());
    const std::vector<int> place = places_of_rows(system, nodes);

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
    ligament.pull = -(follows.transpose() * inner_part(system, place, kept, unit_load(body, half)));
    return ligament;
}

} // namespace demlua::test
