// SPDX-License-Identifier: BSD-3-Clause
// --show-config: the settings of a path, and the place that sets each.
#pragma once

#include "smurf-lint/options.hpp"

namespace smurf::tools {

/// Writes the configuration of options.show_config as a readable configuration, each value with its
/// origin in a comment. Mistakes in it go to standard error.
ExitCode show_config(const LintOptions& options);

}  // namespace smurf::tools
