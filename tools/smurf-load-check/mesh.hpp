// SPDX-License-Identifier: BSD-3-Clause
// Triangles of mesh files, read by assimp.
#pragma once

#include <string>
#include <variant>

#include "smurf-load-check/plan.hpp"
#include "smurf-load-check/shape_files.hpp"

namespace smurf::load_check {

/// All triangles of a file in the file's own frame, or why there are none. The library that reads
/// it may crash on broken files: call this in a child process.
std::variant<TriangleShape, std::string> read_mesh(const std::string& path, const ShapeFiles& from);

}  // namespace smurf::load_check
