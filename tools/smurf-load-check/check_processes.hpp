// SPDX-License-Identifier: BSD-3-Clause
// Runs all checks, each in a separate process.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "smurf-load-check/check.hpp"
#include "smurf-load-check/child.hpp"
#include "smurf-load-check/inputs.hpp"

namespace smurf::load_check {

/// A job and its result.
struct Checked {
  const Job* job = nullptr;
  CheckResult result;

  /// The worst verdict of its stages; `fail` if it could not be run.
  Verdict verdict() const;
};

/// The number of checks per verdict.
struct Tally {
  std::size_t passed = 0, warned = 0, failed = 0, undecided = 0;
};
Tally tally_of(std::span<const Checked> checked);

struct RunOptions {
  CheckOptions check;
  ChildLimits limits;
  int jobs = 1;  ///< at a time; with a trace, one: the next job gets the remaining space
};

struct Run {
  std::vector<Checked> checked;  ///< in the order of the jobs
  std::string trace;  ///< CSV of all jobs, in the same order; without rows unless requested
};

/// `on_finished` receives the number of finished jobs.
Run run_checks(const Inputs& inputs, const RunOptions& options,
               const std::function<void(std::size_t)>& on_finished);

}  // namespace smurf::load_check
