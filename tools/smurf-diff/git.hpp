// SPDX-License-Identifier: BSD-3-Clause
// The diff driver of git.
#pragma once

#include "common/command.hpp"
#include "smurf-diff/options.hpp"

namespace smurf::tools {

/// Compares what git gives: PATH OLD-FILE OLD-HEX OLD-MODE NEW-FILE NEW-HEX NEW-MODE [NEW-PATH
/// HEADER]. The files stand in a folder of git's own; their texts are read in the place of PATH, so
/// that all they name is found. Git ends where a driver fails: what cannot be compared is told in
/// the output, and the exit code is 0.
ExitCode compare_for_git(const Options& options);

}  // namespace smurf::tools
