// SPDX-License-Identifier: BSD-3-Clause
// Collision elements as shapes that ODE can build.
#pragma once

#include "smurf-load-check/body_plan.hpp"
#include "smurf-load-check/shape_files.hpp"
#include "smurf/diagnostic.hpp"

namespace smurf::load_check {

struct ShapeCount {
  std::size_t missing_meshes = 0;  ///< omitted shapes; the linter reports missing files
  std::size_t stand_ins = 0;       ///< boxes in place of moving meshes
};

/// Adds the shapes of all links and reports those that cannot be built. Reads mesh files.
ShapeCount add_shapes(Plan& plan, const ShapeFiles& files, DiagnosticSink& sink);

}  // namespace smurf::load_check
