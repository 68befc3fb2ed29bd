// SPDX-License-Identifier: BSD-3-Clause
// Triangles of mesh files.
#pragma once

#include <string>

#include "smurf-load-check/plan.hpp"
#include "smurf-load-check/shape_files.hpp"

namespace smurf::load_check {

/// All triangles of a file in the file's own frame, or why there are none.
struct MeshReading {
  TriangleShape shape;
  std::string reason;      ///< empty: there are triangles
  bool is_denied = false;  ///< it may not be read, which is not the fault of the file
};

/// STL, OBJ and bobj are read here, COLLADA and glTF by assimp, which may crash on broken files:
/// call this in a child process.
MeshReading read_mesh(const std::string& path, const ShapeFiles& from);

}  // namespace smurf::load_check
