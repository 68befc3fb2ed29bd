// SPDX-License-Identifier: BSD-3-Clause
// What a configuration that --init proposes makes of the findings, tried before it is written.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "smurf-lint/options.hpp"

namespace smurf::tools {

/// A finding that only the targets make an error.
struct RaisedFinding {
  std::string path;  ///< relative to the folder
  std::string rule;
  std::string severity;  ///< that it has without targets
};

/// What --init decides about the programs that load the robots.
struct InitTargets {
  std::vector<std::string> names;     ///< "ros", "gazebo:harmonic"
  std::vector<RaisedFinding> raised;  ///< that keep their severity
};

/// Checks the folder with the configuration that `text_of` makes. Of a target with releases, takes
/// the first release for which the fewest findings become errors: the files are written for one.
/// What is an error for the targets, and is none without them, is in `raised`.
InitTargets try_targets(const std::string& folder, const std::vector<std::string>& names,
                        const std::function<std::string(const InitTargets&)>& text_of,
                        const LintOptions& options);

}  // namespace smurf::tools
