// SPDX-License-Identifier: BSD-3-Clause
// What the command line of smurf-lint says.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/command.hpp"
#include "common/output.hpp"
#include "common/report.hpp"
#include "smurf/limits.hpp"
#include "smurf/lint.hpp"
#include "smurf/rename.hpp"

namespace smurf::tools {

/// Part `number` (from 1) of `count` parts of the files.
struct Shard {
  std::uint64_t number = 1;
  std::uint64_t count = 1;
};

struct LintOptions {
  std::vector<std::string> paths;
  bool only_listed = false;  ///< leave annotation files and meshes alone that no model uses
  std::string stdin_filename;
  std::map<std::string, std::string> packages;
  bool allow_outside = false;  ///< read what models name wherever it lies
  Limits limits;

  std::string config;       ///< "": the nearest one
  bool isolated = false;    ///< read no configuration
  std::string show_config;  ///< a path: show what holds for it and do nothing else
  RuleSelection selection;
  Threshold threshold;
  std::optional<Severity> min_severity;  ///< what is below is left out of every report
  bool has_fail_on = false;              ///< the threshold's severity was given

  bool force_exclude = false;    ///< leave excluded files out even when they are named
  bool no_ignore_files = false;  ///< .gitignore and .smurf-lintignore leave nothing out
  Shard shard;
  bool merge_reports = false;  ///< `paths` are JSON reports; nothing is checked
  bool list_files = false;     ///< say what would be checked, and check nothing

  bool fix = false;           ///< write fixed files
  bool unsafe_fixes = false;  ///< fixes that may change what the model means are fixes too
  bool fix_only = false;      ///< do not report what is left
  bool diff = false;          ///< show what would be changed, and do nothing else
  std::vector<Rename> renames;

  std::string baseline;            ///< file; "": none
  bool generate_baseline = false;  ///< write it, and report nothing
  bool no_ignores = false;         ///< report what comments and the baseline let pass, too

  std::vector<ReportRequest> reports;
  std::string output;  ///< for reports without a file of their own
  bool statistics = false;
  bool shows_all = false;  ///< every finding in a report for people, however many there are
  bool quiet = false;
  ColorChoice color = ColorChoice::automatic;
  std::optional<int> jobs;

  std::string explain;     ///< a rule: show its page and do nothing else
  std::string dump_model;  ///< a path: show what is read of it and do nothing else
  std::string list_rules;  ///< "text" or "json": list the rules and do nothing else
};

/// The result refers to `options`.
Command lint_command(LintOptions& options);

/// Reports options that exclude each other, such as two reports to one place.
std::optional<std::string> find_conflict(const LintOptions& options);

/// Is there such a rule, and if not, which is meant: "there is no rule 'x'; did you mean 'y'?"
std::string no_such_rule(std::string_view id_or_name);

/// What --explain takes: rules by id and name, and sections of the format.
std::vector<std::string_view> explained_words();

}  // namespace smurf::tools
