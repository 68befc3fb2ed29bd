// SPDX-License-Identifier: BSD-3-Clause
// Sets up smurf-lint in a folder.
#pragma once

#include "common/cli/command.hpp"
#include "smurf-lint/options.hpp"

namespace smurf::tools {

/// Looks at the folder of the command line, by default the current one, and writes a configuration;
/// in a git repository also a pre-commit hook and a workflow. Replaces no file. Prints what it
/// found, wrote and left.
ExitCode init(const LintOptions& options);

}  // namespace smurf::tools
