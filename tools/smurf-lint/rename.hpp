// SPDX-License-Identifier: BSD-3-Clause
// --rename: new names in all files of the models and scenes that are planned.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "smurf-lint/fix.hpp"
#include "smurf-lint/options.hpp"
#include "smurf-lint/plan.hpp"
#include "smurf/check.hpp"

namespace smurf::tools {

/// The renamed texts go to the session, in front of those on the disk, where they are loaded again
/// to check that every name still means the same; nothing is written. None when something cannot be
/// renamed, which was said.
std::optional<std::map<std::string, Change>> rename_all(const LintOptions& options,
                                                        const LintPlan& plan, Session& session);

}  // namespace smurf::tools
