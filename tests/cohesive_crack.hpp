// Growth of a crack along a symmetry line with a cohesive zone ahead of it: the independent reference for fracture.
//
// Hillerborg's fictitious crack (Hillerborg, Modeer & Petersson 1976), mode I: the line ahead of a notch is closed until its
// traction reaches the strength; it then transmits a traction that falls with its opening. Half the body is condensed once
// to the nodes of that line; the zone's tip is then moved from node to node, and the openings behind it and the load that
// makes the traction at the tip just the strength are found together. That control passes peaks and snap-backs alike.
//
// Units: length in a_t = K_Ic^2 / (pi s^2), stress in the strength s, Young's modulus one; then G = K_Ic^2 / E = pi.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace demlua::test {

/// A rectangle x in [0, width], y in [-half_height, half_height] notched from x = 0 to `notch` along y = 0.
struct NotchedBody {
    enum class Load {
        tension, // uniform traction on both ends: the load is that traction
        bending, // three points, span 4 width, `half_height` beyond 2 width: the load is the stress 6 M / width^2
    };
    double notch = 0.0;
    double width = 0.0;
    double half_height = 0.0;
    bool mirror_at_start = false; // x = 0 is a symmetry line: half of a plate with a centre notch
    bool mirror_at_end = false;   // x = width is one: half of a plate with notches at both edges
    Load load = Load::tension;
    double poisson = 0.3; // plane stress
};

/// How the half body is divided.
struct LigamentMesh {
    double cell = 0.1;   // nine-node cells ahead of the notch, in a_t
    double reach = 8.0;  // how far they go; the zone's tip must stay within
    double growth = 1.2; // size of a cell over that of its neighbour, beyond
};

/// Half a body seen from its ligament: nodal forces = stiffness * half-openings - load * pull.
struct Ligament {
    std::vector<double> x;     // nodes from the notch on: corners of cells at even numbers, middles between
    Eigen::MatrixXd stiffness; // force over half-opening
    Eigen::VectorXd pull;      // of a unit load on the closed ligament
};

Ligament condense(const NotchedBody& body, const LigamentMesh& mesh);

/// Traction (in s) over opening (in a_t s / E).
enum class Softening {
    linear,  // 1 - w / (2 pi) to zero
    plateau, // 1 to w = pi, then zero
};

/// One state of growth.
struct Growth {
    double tip;       // place of the zone's tip, a_t
    double load;      // in s
    double opening;   // at the notch, a_t s / E
    double zone_from; // where the traction sets in: the notch, or beyond once its opening is past the last
};

/// Every state from the first yielding until the load has fallen to `stop` of its highest. For the plateau until the notch
/// lets go, which is the peak of every body whose stress intensity grows with its crack.
/// Throws std::runtime_error when the tip would leave the fine part of the ligament.
std::vector<Growth> grow(const Ligament& ligament, Softening shape, double stop = 0.99);

/// The highest load, and the state that belongs to it; between the tips computed by a parabola (linear) or a line (plateau).
Growth peak(const std::vector<Growth>& states, Softening shape);

/// Stress intensity under a unit load with the crack at node `corner` (even, from 2): energy released between its two
/// neighbours. In s sqrt(a_t).
double stress_intensity(const Ligament& ligament, int corner);

} // namespace demlua::test
