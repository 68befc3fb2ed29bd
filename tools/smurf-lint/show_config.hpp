// SPDX-License-Identifier: BSD-3-Clause
// --show-config: what holds for a path, and who says so.
#pragma once

#include "smurf-lint/options.hpp"

namespace smurf::tools {

/// Writes the configuration that holds for options.show_config as one that could be read, each
/// value with its origin in a comment. What is wrong with it goes to standard error.
ExitCode show_config(const LintOptions& options);

}  // namespace smurf::tools
