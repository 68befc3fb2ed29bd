// SPDX-License-Identifier: BSD-3-Clause
// The command line over the configuration: what holds in the end.
#pragma once

#include <string>
#include <vector>

#include "smurf-lint/options.hpp"
#include "smurf/check.hpp"

namespace smurf::tools {

/// What the options say of a check.
CheckSettings check_settings(const LintOptions& options);

/// What holds for the whole run.
struct RunSettings {
  std::vector<ReportRequest> reports;
  Threshold threshold;
  std::string baseline;  ///< file; "": none
};
RunSettings merge_run(const ReportWishes& wishes, const LintOptions& options);

}  // namespace smurf::tools
