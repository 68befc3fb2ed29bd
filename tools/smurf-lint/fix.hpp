// SPDX-License-Identifier: BSD-3-Clause
// --fix and --diff: fixes applied in memory until nothing is left to fix, then written or shown.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <span>
#include <string>

#include "smurf-lint/options.hpp"
#include "smurf-lint/plan.hpp"
#include "smurf/check.hpp"

namespace smurf::tools {

struct Change {
  std::string before;
  std::string after;
};

enum class FixEnd {
  nothing_left,  ///< no fix is left
  no_end,        ///< every round found something to fix
  limit          ///< going on would take more than `rechecked-bytes`
};

struct Fixed {
  Report report;                          ///< of the fixed texts
  std::map<std::string, Change> changes;  ///< by path
  std::size_t count = 0;                  ///< findings that were fixed
  FixEnd end = FixEnd::nothing_left;
};

/// Applies fixes and checks again until a round finds none, or the limit is reached. The fixed
/// texts go to the session, in front of those on the disk; nothing is written. The fixes of files
/// that are in no project of the plan are removed from the report: a model may read an installed
/// package, but it does not choose that the package is changed.
Fixed fix_all(const LintOptions& options, const LintPlan& plan, Session& session, Report report,
              const std::function<Report()>& check);

/// Writes every changed file but standard input, all or none. False when one could not be written,
/// which was said, or is a link out of its project.
bool write_changes(const std::map<std::string, Change>& changes, const LintPlan& plan,
                   const LintOptions& options);

/// The changes as `diff -u` shows them, with `git apply`'s a/ and b/ before relative paths. Control
/// characters, which no sound file has, are escaped: it is text for people first.
std::string unified_diff(const std::map<std::string, Change>& changes);

/// "fixed 2 findings" and "3 fixable with --fix ...", a line each; "" when there is nothing to say.
std::string fix_remarks(std::size_t fixed, std::span<const Diagnostic> left);

}  // namespace smurf::tools
