// SPDX-License-Identifier: BSD-3-Clause
// --fix-inertia: other inertias for those that cannot be right.
#pragma once

#include "smurf-lint/fix.hpp"

namespace smurf::tools {

/// The changes in all planned models, and what was assumed, one line per link, on standard error.
/// The session gets the changed texts; nothing is written.
std::map<std::string, Change> fix_inertias(const LintOptions& options, const LintPlan& plan,
                                           Session& session);

}  // namespace smurf::tools
