// SPDX-License-Identifier: BSD-3-Clause
// From the paths on the command line to sorted findings.
#pragma once

#include <vector>

#include "smurf-lint/options.hpp"
#include "smurf-lint/plan.hpp"
#include "smurf-lint/settings.hpp"
#include "smurf/render.hpp"

namespace smurf::tools {

struct Checked {
  SourceMap sources;
  std::vector<Diagnostic> diagnostics;  ///< sorted, without repetitions
  Summary summary;
  RunSettings run;
  std::vector<TargetVerdict> targets;  ///< of all configurations
};

Checked check(const LintOptions& options, const Plan& plan, const FileReader& files);

}  // namespace smurf::tools
