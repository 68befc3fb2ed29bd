// SPDX-License-Identifier: BSD-3-Clause
// The command line of smurf-lint.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/cli/command.hpp"
#include "common/cli/report.hpp"
#include "common/files/output.hpp"
#include "common/rename/xacro_rename.hpp"
#include "lint/inertia_repair.hpp"
#include "smurf/check.hpp"
#include "smurf/limits.hpp"
#include "smurf/lint.hpp"
#include "smurf/load.hpp"
#include "smurf/rename.hpp"

namespace smurf::tools {

inline constexpr std::string_view kSmurfLint = "smurf-lint";

struct LintOptions {
  std::vector<std::string> paths;
  bool only_listed = false;  ///< skip annotation files and meshes that no model uses
  std::string stdin_filename;
  std::map<std::string, std::string> packages;
  XacroSettings xacro;
  bool allow_outside = false;  ///< read all files that models name
  Limits limits;
  std::uint64_t max_seconds = kMaxSeconds;

  std::string config;       ///< "": the nearest one
  bool isolated = false;    ///< read no configuration
  std::string show_config;  ///< a path: only show the settings for it
  RuleSelection selection;
  Threshold threshold;
  std::optional<Severity> min_severity;  ///< less severe findings are omitted from every report
  bool has_fail_on = false;              ///< the user set the severity of the threshold

  bool force_exclude = false;    ///< skip excluded files even if they are named
  bool no_ignore_files = false;  ///< do not apply .gitignore and .smurf-lintignore
  bool init = false;             ///< only write a configuration, a hook and a workflow
  bool opens = false;            ///< open the page of the report in the browser
  bool watch = false;            ///< check again after each change
  bool list_files = false;       ///< only list the files that would be checked

  bool fix = false;           ///< write fixed files
  bool unsafe_fixes = false;  ///< also apply fixes that may change the meaning of the model
  bool fix_only = false;      ///< do not report the remaining findings
  bool diff = false;          ///< only show the changes
  std::vector<Rename> renames;
  bool is_forced = false;  ///< names may be left behind
  std::vector<XacroRename> xacro_renames;
  bool renames_names() const { return !renames.empty() || !xacro_renames.empty(); }
  bool fix_inertia = false;  ///< write other inertias for those that cannot be right
  InertiaSource inertia;

  std::string baseline;            ///< file; "": none
  bool generate_baseline = false;  ///< only write the baseline
  bool no_ignores = false;         ///< also report findings that comments and the baseline suppress

  std::vector<ReportRequest> reports;
  std::string resume;  ///< a file with records, to which those of the other robots are added
  std::string cache;   ///< a folder that keeps records for the next run; "": none
  std::string output;  ///< for reports without a separate file
  bool statistics = false;
  bool shows_all = false;  ///< show all findings in a report for people
  bool quiet = false;
  ColorChoice color = ColorChoice::automatic;
  std::optional<int> jobs;

  std::string explain;                      ///< a rule: only show its page
  std::string masses;                       ///< a path: only show its masses
  std::vector<const Reader*> joint_orders;  ///< readers: only show the orders of joints they build
  std::string collision_matrix;             ///< a path: only write its pairs as an SRDF
  std::optional<int> samples;               ///< of joint positions, for these
  bool csv = false;                         ///< show them as CSV
  std::string dump_model;                   ///< a path: only write its contents
  std::string list_rules;                   ///< "text" or "json": only list the rules
};

/// The result refers to `options`.
Command lint_command(LintOptions& options);

/// Reports options that exclude each other, such as two reports to one place.
std::optional<std::string> find_conflict(const LintOptions& options);

/// An error message if there is no such rule: "there is no rule 'x'; did you mean 'y'?"
std::string no_such_rule(std::string_view id_or_name);

/// Adds the targets that the value of an option names. Each is added once, because a report has one
/// row for each reader.
Setter append_targets(std::vector<const Reader*>& targets);

/// The words that --explain accepts: ids and names of rules, and sections of the format.
std::vector<std::string_view> explained_words();

}  // namespace smurf::tools
