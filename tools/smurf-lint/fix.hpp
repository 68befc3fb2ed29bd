// SPDX-License-Identifier: BSD-3-Clause
// --fix and --diff: fixes applied in memory until nothing is left to fix, then written or shown.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <span>
#include <string>

#include "smurf-lint/lint_plan.hpp"
#include "smurf-lint/options.hpp"
#include "smurf/check.hpp"

namespace smurf::tools {

struct Change {
  std::string before;
  std::string after;
};

using Changes = std::map<std::string, Change>;  ///< by path

enum class FixEnd {
  nothing_left,  ///< no fixes remain
  no_end,        ///< every round found further fixes
  limit          ///< the next round would exceed `rechecked-bytes`
};

struct Fixed {
  Report report;                          ///< checked on the fixed texts
  std::map<std::string, Change> changes;  ///< by path
  std::size_t count = 0;                  ///< findings that were fixed
  std::size_t places = 0;                 ///< changed for them; a finding may stand for many
  FixEnd end = FixEnd::nothing_left;
};

/// Applies fixes and checks again until no fixes remain, or the limit is reached. The session gets
/// the fixed texts, which override those on disk; nothing is written. Fixes of files outside of the
/// projects of the plan are removed from the report: a model may read an installed package, but
/// must not cause changes in it. Only findings that are at least `least` severe are fixed.
Fixed fix_all(const LintOptions& options, const LintPlan& plan, Session& session, Report report,
              Severity least, const std::function<Report()>& check);

/// Writes every changed file except standard input: all or none. If one could not be written, or is
/// a link out of its project, reports this and returns false.
bool write_changes(const std::map<std::string, Change>& changes, const LintPlan& plan,
                   const LintOptions& options);

/// The changes in the format of `diff -u`, with `git apply`'s a/ and b/ before relative paths.
/// Escapes control characters, which sound files do not contain: the text is mainly for people.
std::string unified_diff(const std::map<std::string, Change>& changes);

/// "fixed 2 findings at 5 places in 2 files" and "3 fixable with --fix ...", one per line; "" if
/// there are none. `fixed` may be null. Less severe findings are not counted, because nobody sees
/// them.
std::string fix_remarks(const Fixed* fixed, std::span<const Diagnostic> left, Severity least);

}  // namespace smurf::tools
