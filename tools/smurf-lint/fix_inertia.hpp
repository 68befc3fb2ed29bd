// SPDX-License-Identifier: BSD-3-Clause
// --fix-inertia: other inertias for those that cannot be right.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "smurf-lint/fix.hpp"

namespace smurf::tools {

/// Changed files, and what was done, one line per link.
struct InertiaChanges {
  Changes files;
  std::vector<std::string> done;
  std::vector<std::string> refused;  ///< with what to change by hand
};
/// The changes in all planned models. The session gets the changed texts; nothing is written. None
/// if a xacro file would then make another robot; this is reported.
std::optional<InertiaChanges> fix_inertias(const LintOptions& options, const LintPlan& plan,
                                           Session& session);

/// The findings of a report, those about inertias with the changes of --fix-inertia: for pages.
std::vector<Diagnostic> with_inertia_repairs(std::span<const Diagnostic> found,
                                             const LintOptions& options, const LintPlan& plan,
                                             Session& session);

}  // namespace smurf::tools
