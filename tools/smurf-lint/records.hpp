// SPDX-License-Identifier: BSD-3-Clause
// `--format jsonl` and `--resume`: a line for each robot and scene, as soon as it is checked.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/cli/command.hpp"
#include "smurf-lint/lint_plan.hpp"
#include "smurf-lint/options.hpp"

namespace smurf::tools {

/// Whether the report is written while robots are checked.
bool writes_records(const LintOptions& options);

/// --resume and --cache.
std::vector<Option> record_options(LintOptions& options);

/// Why these options exclude records, which are written while robots are checked; none if they do
/// not.
std::optional<std::string> records_conflict(const LintOptions& options);

/// Checks each robot and scene by itself, and writes its record. Memory does not grow with their
/// number, but for the plan.
ExitCode run_records(const LintOptions& options);

}  // namespace smurf::tools
