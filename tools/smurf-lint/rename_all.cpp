// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/rename_all.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "common/files/input.hpp"
#include "common/files/output.hpp"
#include "common/rename/planned_rename.hpp"
#include "common/rename/xacro_rename.hpp"
#include "plan/xacro_files.hpp"
#include "smurf-lint/left_names.hpp"
#include "smurf-lint/settings.hpp"
#include "smurf/names.hpp"

namespace smurf::tools {

namespace {

/// "macro:wheel=tyre", "parameter:wheel.radius=r"
std::optional<std::string> append_xacro_rename(XacroNameKind kind, std::string_view names,
                                               std::vector<XacroRename>& renames) {
  const std::size_t equals = names.find('=');
  const bool has_macro = kind == XacroNameKind::parameter || kind == XacroNameKind::block;
  const std::size_t point = has_macro ? names.substr(0, equals).rfind('.') : std::string_view::npos;
  if (equals == std::string_view::npos || equals == 0 ||
      (has_macro && point == std::string_view::npos)) {
    const std::string form = has_macro ? ":MACRO.NAME=NEW" : ":NAME=NEW";
    return "write " + std::string(to_string(kind)) + form;
  }
  const std::size_t begin = has_macro ? point + 1 : 0;
  renames.push_back({kind, std::string(names.substr(0, has_macro ? point : 0)),
                     std::string(names.substr(begin, equals - begin)),
                     std::string(names.substr(equals + 1))});
  return std::nullopt;
}

void note(RenamedXacro& renamed, Changes& changes) {
  const SourceMap& sources = renamed.family.sources;
  for (const Edit& edit : renamed.edits) {
    const auto [change, is_new] = changes.try_emplace(sources.path(edit.span.source));
    if (is_new) change->second.before = sources.text(edit.span.source);
  }
  for (FixedText& file : renamed.texts) changes[file.path].after = std::move(file.text);
}

/// Renames one name of xacro in all robots that have it; the reason why it cannot be renamed, or
/// "".
std::string rename_one(const XacroRename& rename, const LintPlan& plan, const LintOptions& options,
                       Session& session, const FileReader& changeable, Changes& changes) {
  std::string missing = "no xacro file was named";
  bool is_done = false;
  std::vector<PlannedFile> all = plan.models;
  all.insert(all.end(), plan.others.begin(), plan.others.end());
  for (const PlannedFile& planned : all) {
    if (!xacro::is_xacro_file(planned.path)) continue;
    const XacroFiles files = xacro_files_around(planned.path, session.files(), options.limits);
    RenamedXacro renamed =
        rename_in_xacro(files, planned.path, rename, check_settings(options), session, changeable);
    if (renamed.is_known && !renamed.problems.empty()) return renamed.problems.front();
    if (!renamed.is_known) missing = renamed.problems.front();
    is_done = is_done || renamed.is_known;
    note(renamed, changes);
  }
  return is_done ? std::string() : missing;
}

std::optional<Changes> rename_xacro(const LintOptions& options, const LintPlan& plan,
                                    Session& session) {
  ConfinedFiles changeable;
  confine_to_changeable(changeable, options, plan);
  Changes changes;
  for (const XacroRename& one : options.xacro_renames) {
    const std::string problem = rename_one(one, plan, options, session, changeable, changes);
    if (!problem.empty()) {
      complain("smurf-lint", "nothing was renamed: " + problem);
      return std::nullopt;
    }
    if (one.kind != XacroNameKind::argument) continue;
    std::vector<std::string> changed;
    for (const auto& [path, change] : changes) changed.push_back(path);
    const Rename of_argument{{}, one.from, one.to};
    const auto includes_none = [](const std::string&) { return std::set<std::string>(); };
    const LeftNames left = names_left(std::span(&of_argument, 1), changed, {}, session.files(),
                                      options.limits, includes_none);
    for (const std::string& place : left.mentions) complain("smurf-lint", place);
  }
  return changes;
}

}  // namespace

Setter append_renames(LintOptions& options) {
  return [&options](std::string_view value) -> std::optional<std::string> {
    const std::size_t colon = value.find(':');
    const std::string_view kind = value.substr(0, std::min(colon, value.size()));
    if (const auto of_xacro = find_xacro_name_kind(kind); of_xacro && colon != value.npos) {
      return append_xacro_rename(*of_xacro, value.substr(colon + 1), options.xacro_renames);
    }
    Rename rename;
    if (colon != std::string_view::npos) rename.kind = find_name_kind(value.substr(0, colon));
    const std::string_view names = rename.kind ? value.substr(colon + 1) : value;
    const std::size_t equals = names.find('=');
    if (equals == std::string_view::npos || equals == 0) {
      return "'" + std::string(value) + "' is not KIND:NAME=NEW";
    }
    rename.from = names.substr(0, equals);
    rename.to = names.substr(equals + 1);
    options.renames.push_back(std::move(rename));
    return std::nullopt;
  };
}

std::optional<Changes> rename_all(const LintOptions& options, const LintPlan& plan,
                                  Session& session) {
  if (!options.xacro_renames.empty()) return rename_xacro(options, plan, session);
  ConfinedFiles changeable;
  confine_to_changeable(changeable, options, plan);
  std::set<std::string> loaded;
  Renamed renamed = rename_planned(plan, check_settings(options), options.renames, session,
                                   changeable, plan.standard_input, &loaded, options.is_forced);
  for (const std::string& problem : renamed.problems) {
    complain("smurf-lint", "nothing was renamed: " + problem);
  }
  if (!renamed.problems.empty()) return std::nullopt;
  Changes changes;
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
  std::map<std::string, std::string_view> texts;  // of files that are not loaded, by identity
  for (const auto& [path, change] : changes) {
    if (const std::string id = identity(path); !loaded.contains(id))
      texts.emplace(id, change.after);
  }
  const LeftNames left = names_left(options.renames, changed, loaded, session.files(),
                                    options.limits, included_by, texts);
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
