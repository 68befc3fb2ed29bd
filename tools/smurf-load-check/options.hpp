// SPDX-License-Identifier: BSD-3-Clause
// The command line of smurf-load-check.
#pragma once

#include "common/cli/command.hpp"
#include "common/cli/report.hpp"
#include "smurf-load-check/check_processes.hpp"
#include "smurf-load-check/inputs.hpp"

namespace smurf::load_check {

struct Options {
  InputOptions input;
  CheckOptions check;
  ChildLimits limits;
  std::optional<int> jobs;
  std::string format = "full";
  std::string output, trace;
  std::vector<tools::ReportRequest> reports;
  tools::Threshold threshold;
  tools::ColorChoice color = tools::ColorChoice::automatic;
  bool quiet = false;
  bool all = false;
};

tools::Command command_of(Options& options);

}  // namespace smurf::load_check
