// SPDX-License-Identifier: BSD-3-Clause
// The robot or scene that was checked, as the page of findings shows it.
#pragma once

#include <string>

#include "smurf-lint/lint_plan.hpp"
#include "smurf-lint/options.hpp"
#include "smurf/check.hpp"

namespace smurf::tools {

/// The page of `smurfs-flatten --format html`; "" if the plan has more than one robot or scene, if
/// poses are unknown, and if this build has no viewer.
std::string picture_of(const LintOptions& options, const LintPlan& plan, Session& session);

}  // namespace smurf::tools
