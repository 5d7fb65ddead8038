// Rest, steady vibration and the first frequency of an assembled body.
#include "tests/finite_elements.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>

#include <cmath>
#include <complex>
#include <cstddef>
#include <stdexcept>

namespace demlua::fe {

namespace {

template <class Vector>
Vector free_part(const System& system, const Field& field) {
    Vector part(system.stiffness.rows());
    for (std::size_t k = 0; k < system.row.size(); ++k) {
        if (system.row[k] >= 0) {
            part[system.row[k]] = field[static_cast<Eigen::Index>(k)];
        }
    }
    return part;
}

template <class Vector>
Vector whole_field(const System& system, const Vector& part) {
    Vector field = Vector::Zero(static_cast<Eigen::Index>(system.row.size()));
    for (std::size_t k = 0; k < system.row.size(); ++k) {
        if (system.row[k] >= 0) {
            field[static_cast<Eigen::Index>(k)] = part[system.row[k]];
        }
    }
    return field;
}

using Factors = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;

void factorize(Factors& factors, const System& system) {
    factors.compute(system.stiffness);
    const auto pivots = factors.vectorD();
    // A rigid motion leaves a pivot of round-off size.
    if (factors.info() != Eigen::Success || pivots.minCoeff() < 1e-13 * pivots.maxCoeff()) {
        throw std::runtime_error("finite elements: the supports leave the body movable");
    }
}

} // namespace

Field solve_static(const System& system, const Field& forces) {
    Factors factors;
    factorize(factors, system);
    return whole_field<Field>(system, factors.solve(free_part<Field>(system, forces)));
}

ComplexField solve_harmonic(const System& system, const Field& forces, double frequency, double mass_damping) {
    const std::complex<double> inertia{-frequency * frequency, frequency * mass_damping};
    const Eigen::SparseMatrix<std::complex<double>> dynamic =
        system.stiffness.cast<std::complex<double>>() + inertia * system.mass.cast<std::complex<double>>();
    Eigen::SparseLU<Eigen::SparseMatrix<std::complex<double>>> factors;
    factors.compute(dynamic);
    if (factors.info() != Eigen::Success) {
        throw std::runtime_error("finite elements: undamped resonance");
    }
    return whole_field<ComplexField>(system, factors.solve(free_part<ComplexField>(system, forces)));
}

double first_frequency(const System& system, const Field& start) {
    Factors factors;
    factorize(factors, system);
    Field shape = free_part<Field>(system, start);
    double squared = 0.0;
    for (int turn = 0; turn < 200; ++turn) {
        const Field momentum = system.mass * shape;
        const Field bent = factors.solve(momentum);
        // Rayleigh's quotient: its error is the square of the shape's.
        const double before = squared;
        squared = bent.dot(momentum) / bent.dot(system.mass * bent);
        shape = bent / bent.norm();
        if (std::fabs(squared - before) < 1e-13 * squared) {
            return std::sqrt(squared);
        }
    }
    throw std::runtime_error("finite elements: inverse iteration did not converge");
}

} // namespace demlua::fe
