// SPDX-License-Identifier: BSD-3-Clause
// Checks again whenever a file has changed.
#pragma once

#include <functional>
#include <set>
#include <string>

#include "common/cli/command.hpp"
#include "smurf-lint/options.hpp"

namespace smurf::tools {

/// Checks once, and adds the paths that were asked for.
using WatchedCheck = std::function<ExitCode(std::set<std::string>& seen)>;

/// Checks at once, and again after each change of a seen file and when a named folder contains
/// other robots, until Ctrl-C; then returns kDone.
ExitCode watch(const LintOptions& options, const WatchedCheck& check);

}  // namespace smurf::tools
