// SPDX-License-Identifier: BSD-3-Clause
// --rename: renames things in all files of the planned models and scenes.
#pragma once

#include <optional>
#include <string>

#include "smurf-lint/fix.hpp"
#include "smurf-lint/lint_plan.hpp"
#include "smurf-lint/options.hpp"
#include "smurf/check.hpp"

namespace smurf::tools {

/// "joint:elbow=elbow_left", or a name of xacro; without a known kind, all text before `=` is the
/// name.
Setter append_renames(LintOptions& options);

/// The session gets the renamed texts, which override those on disk, and loads them again to check
/// that every name has the same meaning; nothing is written. If something cannot be renamed,
/// reports this and returns none.
std::optional<Changes> rename_all(const LintOptions& options, const LintPlan& plan,
                                  Session& session);

}  // namespace smurf::tools
