// SPDX-License-Identifier: BSD-3-Clause
// The diff driver of git.
#pragma once

#include "common/cli/command.hpp"
#include "smurf-diff/options.hpp"

namespace smurf::tools {

/// Compares the files that git passes: PATH OLD-FILE OLD-HEX OLD-MODE NEW-FILE NEW-HEX NEW-MODE
/// [NEW-PATH HEADER]. The files are in a temporary folder of git; their texts are read in place of
/// PATH, so that all files they name are found. Git stops if a driver fails, so files that cannot
/// be compared are named in the output, and the exit code is 0.
ExitCode compare_for_git(const Options& options);

}  // namespace smurf::tools
