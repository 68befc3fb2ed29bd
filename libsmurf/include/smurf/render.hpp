// SPDX-License-Identifier: BSD-3-Clause
// Diagnostics and rules as text for people and as reports for programs.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/source.hpp"
#include "smurf/verdict.hpp"

namespace smurf {

/// A companion of robots ("controllers.yaml") that was seen, and not compared with a robot.
struct NotCompared {
  std::string path;
  std::string_view kind;
  std::string reason;  ///< "none of its 6 joints is known here; nearest: `joint_1`"
  std::string next;    ///< what to do: "name its robot as well"
};

/// Counts for the summary line and the reports.
struct Summary {
  std::size_t errors = 0;
  std::size_t warnings = 0;
  std::size_t infos = 0;
  std::size_t suppressed = 0;
  std::size_t files = 0;
  std::size_t models = 0;
  std::size_t scenes = 0;
  /// Kinds of companions ("SRDF") and how many of each were compared with robots.
  std::vector<std::pair<std::string_view, std::size_t>> companions = {};
  /// The robots with which SRDFs were compared that a user named without them; "" for none.
  std::set<std::string> robots_of_srdfs = {};
  std::vector<NotCompared> not_compared = {};
  bool is_strict = false;  ///< each of these ends the run with a failure
  /// What a user did not ask for: "`r.urdf.xacro` with `model:=mk3`, from `launch/d.launch.py`";
  /// "URDFs that smurf2urdf makes of MJCF files, for gazebo".
  std::set<std::string> assumptions = {};
  std::size_t links = 0;  ///< symbolic links that lead out of a folder, which were not followed
};
/// Counts findings by severity; the caller sets the other counts.
Summary summarize(std::span<const Diagnostic> diagnostics);

/// What each target makes of one of several robots or scenes.
struct RobotAnswers {
  std::string path;             ///< as it was planned; of a xacro, with its arguments
  std::vector<Answer> answers;  ///< in the order of the targets
  /// Of its findings in the report, also in companions that it shares with other robots, but not
  /// those in launch files and build files around it.
  std::optional<Severity> worst = {};
  bool is_unknown = false;  ///< it could not be expanded, so nothing of it was checked
};

/// The layout of text for a terminal.
struct TextStyle {
  bool color = false;
  int width = 0;  ///< columns of the terminal; 0: cut only lines above 2000 columns
};

/// The tool that made a report.
struct ToolName {
  std::string_view name;
  std::string_view version;
};

/// One diagnostic with source frames, labels, notes and help; ends with an empty line.
std::string render_full(const Diagnostic& diagnostic, const SourceMap& sources,
                        const TextStyle& style = {});
/// "path:line:col: severity[ID] message (help)" and a line end.
std::string render_concise(const Diagnostic& diagnostic, const SourceMap& sources,
                           const TextStyle& style = {});
/// The headline, the place and, on request, the help, without source lines and empty lines.
std::string render_brief(const Diagnostic& diagnostic, const SourceMap& sources, bool has_help,
                         const TextStyle& style = {});

/// Findings of which each group has one cause, as one finding: "12 joints (`a`, `b` and 10 more)
/// are ...".
struct GroupedFindings {
  std::string text;
  bool is_complete = true;  ///< each finding is shown by itself
};
/// Errors first, then in the order of `diagnostics`, in at most `most_lines` lines if that is
/// possible: groups that do not fit lose their source lines, then they are counted.
GroupedFindings render_grouped(std::span<const Diagnostic> diagnostics, const SourceMap& sources,
                               std::size_t most_lines, const TextStyle& style);
/// "found 1 error and 2 warnings in 3 files (1 model)" and a line end; further lines list
/// suppressed findings and unchecked files.
std::string render_summary(const Summary& summary, const TextStyle& style);
/// Two columns: whether each reader loads the files, and the first reason with its place.
std::string render_targets(std::span<const TargetVerdict> targets, const SourceMap& sources,
                           const TextStyle& style);
/// "33 robots: 30 are fine, 2 have warnings (a.urdf and b.urdf), 1 has errors (c.urdf)", and an
/// empty line. A robot that could not be expanded is not checked, and not fine. Empty for fewer
/// than two robots, and when all are fine.
std::string render_fleet(std::span<const RobotAnswers> robots);
/// A table of robots and targets, the robots at which most targets fail first, and for each target
/// the number of robots that it loads. Empty for fewer than two robots, and when each target loads
/// all of them without losses.
std::string render_robots(std::span<const RobotAnswers> robots,
                          std::span<const TargetVerdict> targets, const TextStyle& style);
/// One line per rule, the most frequent first: "  12  error    SML3101 unknown-joint". At most
/// `most` lines.
std::string render_statistics(std::span<const Diagnostic> diagnostics, const TextStyle& style,
                              std::size_t most = std::numeric_limits<std::size_t>::max());

/// Options of a report for people.
struct OverviewOptions {
  Severity least = Severity::warning;
  bool shows_all = false;      ///< all findings, however many
  bool shows_answers = false;  ///< infos about xacro and the files of ROS, in a short report
};
/// Whether a report for people shows a finding.
bool is_shown(const Diagnostic& diagnostic, const OverviewOptions& options);
/// The options for these findings: in a short report, infos of the rules about xacro and about what
/// surrounds a robot are shown, because they are often the answer.
OverviewOptions show_answers(OverviewOptions options, std::span<const Diagnostic> diagnostics);
/// Findings for people: errors first, then by file. Shows three findings per rule and file. Shows
/// repeated messages only in the first file. After about 150 lines, it only names the other files.
/// Counts the omitted findings. `diagnostics` are sorted by file.
std::string render_overview(std::span<const Diagnostic> diagnostics, const SourceMap& sources,
                            const OverviewOptions& options, const TextStyle& style);
/// The JSON report of schemas/lint-report.schema.json.
std::string render_json(std::span<const Diagnostic> diagnostics, const SourceMap& sources,
                        const Summary& summary, const ToolName& tool,
                        std::span<const TargetVerdict> targets = {});

/// What a robot is made of.
struct RobotSize {
  std::size_t links = 0;
  double mass = 0;  ///< kg: the sum of all masses that its links state
};

/// What is said about one of many robots and scenes.
struct Record {
  std::string_view path;
  std::span<const Diagnostic> diagnostics{};
  Summary summary{};
  std::span<const TargetVerdict> targets{};
  std::optional<RobotSize> size{};  ///< of a robot that could be read
  std::string digest{};             ///< of the bytes of the file; "": it was not read
};
/// A line of JSON, with its line end: path, digest, ok, what each target does, counts, links, mass,
/// findings.
std::string render_record(const Record& record, const SourceMap& sources);

/// The name of a file in formats of code hosts: its path from the top of the repository, with '/'.
/// Absolute for files outside.
using RepositoryPath = std::function<std::string(const std::string& path)>;

/// A SARIF 2.1.0 log with one run, as GitHub code scanning reads it; `site` is the web site that
/// explains `rules`. Companions that were not compared are notifications of the run.
std::string render_sarif(std::span<const Diagnostic> diagnostics, const SourceMap& sources,
                         std::span<const Rule* const> rules, const ToolName& tool,
                         std::string_view site, const RepositoryPath& in_repository,
                         const Summary& summary = {});
/// GitHub workflow commands: one "::error file=..." line each.
std::string render_github(std::span<const Diagnostic> diagnostics, const SourceMap& sources,
                          const RepositoryPath& in_repository);
/// A GitLab code quality report.
std::string render_gitlab(std::span<const Diagnostic> diagnostics, const SourceMap& sources,
                          const RepositoryPath& in_repository);
/// A JUnit report: one test case per file, also for files without findings. Findings from
/// `least_failure` on are failures, others are output; without it, there are no failures.
std::string render_junit(std::span<const Diagnostic> diagnostics, const SourceMap& sources,
                         const ToolName& tool, std::optional<Severity> least_failure);

/// The parts of the page of render_html() beside the findings.
struct PageParts {
  std::string_view remarks{};  ///< lines of text below the counts
  std::string_view picture{};  ///< the page of the scene format html, or empty
  std::span<const RobotAnswers> robots{};
};
/// A self-contained HTML page with all findings, their source lines, rules and fixes. It can be
/// searched and filtered.
std::string render_html(std::span<const Diagnostic> diagnostics, const SourceMap& sources,
                        const Summary& summary, const ToolName& tool,
                        std::span<const TargetVerdict> targets, const PageParts& parts);

/// The address of the page of a rule on the web site of a version, which scripts/site makes.
std::string rule_address(const Rule& rule, std::string_view site);
/// The page of one rule, for `--explain`.
std::string render_rule(const Rule& rule, const TextStyle& style);
/// One line per rule, for `--list-rules`.
std::string render_rule_list(std::span<const Rule* const> rules, const TextStyle& style);
/// The losses of a conversion, as schemas/loss-report.schema.json describes them. The class of a
/// loss is the name of its rule.
std::string render_losses_json(std::span<const Diagnostic> losses, const SourceMap& sources,
                               const ToolName& tool);

/// A JSON array with the texts of all rules.
std::string render_rule_list_json(std::span<const Rule* const> rules);

}  // namespace smurf
