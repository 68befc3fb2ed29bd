// SPDX-License-Identifier: BSD-3-Clause
// What options such as --masses show of one robot.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "smurf-lint/options.hpp"
#include "smurf/linked.hpp"

namespace smurf::tools {

/// Loads the model at `path`, and writes the text that `show` makes of it; none if `show` has
/// reported an error. Its robot is set. Errors go to standard error.
ExitCode show_model(const LintOptions& options, const std::string& path,
                    const std::function<std::optional<std::string>(const LinkedModel&)>& show);

}  // namespace smurf::tools
