// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/rename.hpp"

#include <set>
#include <string_view>
#include <utility>

#include "common/input.hpp"
#include "common/output.hpp"
#include "common/planned_rename.hpp"
#include "smurf-lint/left_names.hpp"
#include "smurf-lint/settings.hpp"
#include "smurf/names.hpp"

namespace smurf::tools {

Setter append_renames(std::vector<Rename>& renames) {
  return [&renames](std::string_view value) -> std::optional<std::string> {
    const std::size_t colon = value.find(':');
    Rename rename;
    if (colon != std::string_view::npos) rename.kind = find_name_kind(value.substr(0, colon));
    const std::string_view names = rename.kind ? value.substr(colon + 1) : value;
    const std::size_t equals = names.find('=');
    if (equals == std::string_view::npos || equals == 0) {
      return "'" + std::string(value) + "' is not KIND:NAME=NEW";
    }
    rename.from = names.substr(0, equals);
    rename.to = names.substr(equals + 1);
    renames.push_back(std::move(rename));
    return std::nullopt;
  };
}

std::optional<std::map<std::string, Change>> rename_all(const LintOptions& options,
                                                        const LintPlan& plan, Session& session) {
  ConfinedFiles changeable;
  confine_to_changeable(changeable, options, plan);
  std::set<std::string> loaded;
  Renamed renamed = rename_planned(plan, check_settings(options), options.renames, session,
                                   changeable, plan.standard_input, &loaded);
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
  const auto included_by = [&](const std::string& path) -> std::optional<std::set<std::string>> {
    const LoadedExpansion loaded_root = session.load_xacro(path, check_settings(options));
    if (!loaded_root.expansion.is_complete) return std::nullopt;
    std::set<std::string> included{identity(path)};
    for (const std::string& one : loaded_root.expansion.included) included.insert(identity(one));
    return included;
  };
  const LeftNames left =
      names_left(options.renames, changed, loaded, session.files(), options.limits, included_by);
  for (const std::string& place : left.mentions) complain("smurf-lint", place);
  for (const std::string& place : left.misfits) complain("smurf-lint", place);
  if (!left.misfits.empty() && !options.is_forced) {
    complain("smurf-lint", "nothing was renamed: names would be left behind; --force renames the "
                           "others");
    return std::nullopt;
  }
  return changes;
}

}  // namespace smurf::tools
