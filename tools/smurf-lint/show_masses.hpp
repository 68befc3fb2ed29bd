// SPDX-License-Identifier: BSD-3-Clause
// --masses: a table of the masses of a robot.
#pragma once

#include "smurf-lint/options.hpp"

namespace smurf::tools {

/// Writes the table. Errors go to standard error.
ExitCode show_masses(const LintOptions& options);

}  // namespace smurf::tools
