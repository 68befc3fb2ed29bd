// SPDX-License-Identifier: BSD-3-Clause
// What options such as --masses show of one robot.
#pragma once

#include <functional>
#include <string>

#include "smurf-lint/options.hpp"
#include "smurf/linked.hpp"

namespace smurf::tools {

/// Loads the model at `path`, and writes the text that `show` makes of it. Its robot is set. Errors
/// go to standard error.
ExitCode show_model(const LintOptions& options, const std::string& path,
                    const std::function<std::string(const LinkedModel&)>& show);

}  // namespace smurf::tools
