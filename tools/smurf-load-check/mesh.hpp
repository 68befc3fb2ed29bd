// SPDX-License-Identifier: BSD-3-Clause
// Triangles of mesh files.
#pragma once

#include <string>

#include "smurf-load-check/body_plan.hpp"
#include "smurf-load-check/shape_files.hpp"

namespace smurf::load_check {

/// All triangles of a file, before any scale (smurf/mesh_triangles.hpp), or the reason.
struct MeshReading {
  TriangleShape shape;
  std::string reason;      ///< empty if there are triangles
  bool is_denied = false;  ///< access is denied, which is not a fault of the file
};

MeshReading read_mesh(const std::string& path, const ShapeFiles& from);

}  // namespace smurf::load_check
