// SPDX-License-Identifier: BSD-3-Clause
// From the paths on the command line to sorted findings.
#pragma once

#include <vector>

#include "smurf-lint/options.hpp"
#include "smurf/render.hpp"

namespace smurf::tools {

struct Checked {
  SourceMap sources;
  std::vector<Diagnostic> diagnostics;  ///< sorted, without repetitions
  Summary summary;
  bool has_failed = false;  ///< something could not be read; it was said on standard error
};

Checked check(const LintOptions& options);

}  // namespace smurf::tools
