// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/rename.hpp"

#include <utility>

#include "common/output.hpp"
#include "common/planned_rename.hpp"
#include "smurf-lint/launch_files.hpp"
#include "smurf-lint/settings.hpp"

namespace smurf::tools {

std::optional<std::map<std::string, Change>> rename_all(const LintOptions& options,
                                                        const LintPlan& plan, Session& session) {
  ConfinedFiles changeable;
  confine_to_changeable(changeable, options, plan);
  Renamed renamed = rename_planned(plan, check_settings(options), options.renames, session,
                                   changeable, plan.standard_input);
  for (const std::string& problem : renamed.problems) {
    complain("smurf-lint", "nothing was renamed: " + problem);
  }
  if (!renamed.problems.empty()) return std::nullopt;
  std::map<std::string, Change> changes;
  const SourceMap& sources = session.loaded_sources();
  for (const Edit& edit : renamed.edits) {  // a file may have thousands of them
    const auto [change, is_new] = changes.try_emplace(sources.path(edit.span.source));
    if (is_new) change->second.before = sources.text(edit.span.source);
  }
  std::vector<std::string> changed;
  for (FixedText& file : renamed.texts) {
    changed.push_back(file.path);
    changes[file.path].after = std::move(file.text);
  }
  for (const std::string& place : launch_files_with(options.renames, changed, session.files())) {
    complain("smurf-lint", place);
  }
  return changes;
}

}  // namespace smurf::tools
