// SPDX-License-Identifier: BSD-3-Clause
// The effective settings: the command line combined with the configuration.
#pragma once

#include <string>
#include <vector>

#include "smurf-lint/options.hpp"
#include "smurf/check.hpp"

namespace smurf::tools {

/// The options that apply to a check.
CheckSettings check_settings(const LintOptions& options);

/// The settings of the whole run.
struct RunSettings {
  std::vector<ReportRequest> reports;
  Threshold threshold;
  std::string baseline;  ///< file; "": none
};
/// Leaves findings of less than this severity out.
void leave_out_below(Severity least, Report& report);
RunSettings merge_run(const ReportSettings& report, const LintOptions& options);

}  // namespace smurf::tools
