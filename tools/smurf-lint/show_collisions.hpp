// SPDX-License-Identifier: BSD-3-Clause
// --collision-matrix: the pairs of links whose collisions a motion planner need not check.
#pragma once

#include "smurf-lint/options.hpp"

namespace smurf::tools {

Option collision_matrix_option(LintOptions& options);
/// How many joint positions it tries.
Option samples_option(LintOptions& options);

ExitCode show_collisions(const LintOptions& options);

}  // namespace smurf::tools
