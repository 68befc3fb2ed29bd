// SPDX-License-Identifier: BSD-3-Clause
// All checks, each in a process of its own.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "smurf-load-check/check.hpp"
#include "smurf-load-check/child.hpp"
#include "smurf-load-check/inputs.hpp"

namespace smurf::load_check {

/// A job and what came of it.
struct Checked {
  const Job* job = nullptr;
  CheckResult result;

  /// The worst of its stages; `fail` when it could not be run.
  Verdict verdict() const;
};

/// How many checks ended how.
struct Tally {
  std::size_t passed = 0, warned = 0, failed = 0, undecided = 0;
};
Tally tally_of(std::span<const Checked> checked);

struct RunOptions {
  CheckOptions check;
  ChildLimits limits;
  int jobs = 1;  ///< at a time; with a trace it is always one, which leaves its room to the next
};

struct Run {
  std::vector<Checked> checked;  ///< in the order of the jobs
  std::string trace;             ///< CSV of all, in the same order; without rows unless asked for
};

/// `on_finished` gets the number of those done.
Run run_checks(const Inputs& inputs, const RunOptions& options,
               const std::function<void(std::size_t)>& on_finished);

}  // namespace smurf::load_check
