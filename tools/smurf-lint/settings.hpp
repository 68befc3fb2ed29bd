// SPDX-License-Identifier: BSD-3-Clause
// The command line over the configuration: what holds in the end.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "smurf-lint/options.hpp"
#include "smurf/config.hpp"

namespace smurf::tools {

/// What holds for the files of one configuration.
struct Settings {
  RuleSelection selection;
  std::map<std::string, std::string> packages;
};
Settings merge(const Config& config, const LintOptions& options);

/// What holds for the whole run, by the configuration of the first PATH.
struct RunSettings {
  std::vector<ReportRequest> reports;
  Threshold threshold;
  std::string baseline;  ///< file; "": none
  Span baseline_place;   ///< where the configuration names it; empty when the command line does
};
RunSettings merge_run(const Config& config, const LintOptions& options);

/// `path` as seen from `folder`, both looked up in the file system; "" when it lies elsewhere.
std::string path_inside(const std::string& path, const std::string& folder);

}  // namespace smurf::tools
