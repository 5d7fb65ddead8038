// Snapshots as text of VTK XML files: appended binary, compressed. The only file that sees VTK is vtu.cpp.
#pragma once

#include "engine/observe/snapshot.hpp"

#include <string>

namespace demlua::output {

/// Elements as vertices with the element fields as point data; the time as field data "TimeValue". Plane vectors become
/// vectors with z = 0, stresses three components named xx, yy, xy. Throws RunError when VTK cannot make the text, and
/// for a field whose length does not fit.
std::string elements_vtu(const observe::Snapshot& snapshot);

/// Bonds as lines between the centres of their elements with the bond fields as cell data; else the same.
std::string bonds_vtu(const observe::Snapshot& snapshot);

/// Pieces of crack as lines with points of their own, and the crack fields as cell data; else the same.
std::string cracks_vtu(const observe::Snapshot& snapshot);

/// Walls as one line each through points of their own, with their names and the wall fields as cell data; else the same.
std::string walls_vtu(const observe::Snapshot& snapshot);

/// The VTK this program was linked with, e.g. "9.1.0".
std::string vtk_version();

} // namespace demlua::output
