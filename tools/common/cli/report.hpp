// SPDX-License-Identifier: BSD-3-Clause
// Reports: their formats and files, and the exit code.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/cli/command.hpp"
#include "common/files/output.hpp"
#include "smurf/render.hpp"

namespace smurf::tools {

/// The contents of a report, as views.
struct Results {
  std::span<const Diagnostic> diagnostics;  ///< finished: sorted, without repetitions
  const SourceMap& sources;
  Summary summary;
  std::span<const TargetVerdict> targets = {};
  std::string_view tool;
  std::span<const RobotAnswers> robots = {};  ///< of the targets, when there are several robots
  std::string remarks{};                      ///< for people: lines after the summary
  bool quiet = false;                         ///< no summary
  bool counts_only = false;                   ///< for people: the number of findings of each rule
  OverviewOptions overview{};                 ///< for people
  std::optional<Severity> least_failure =
      Severity::error;                     ///< for JUnit: the threshold of the exit code
  std::function<std::string()> picture{};  ///< for a page: PageParts::picture
};

struct ReportFormat {
  std::string_view name;
  std::string_view help;
  std::string (*render)(const Results& results, const TextStyle& style);
};
/// Null if there is no such format.
const ReportFormat* find_report_format(std::string_view name);

/// The format that smurf-lint writes while it checks.
inline constexpr std::string_view kRecords = "jsonl";

struct ReportRequest {
  const ReportFormat* format = nullptr;
  std::string file;  ///< "": the tool's default; "-": standard output
};

/// Appends "FORMAT" or "FORMAT=FILE".
Setter append_report(std::vector<ReportRequest>& requests);
std::vector<std::string_view> report_format_names();
/// The names of the formats, for --help.
std::string_view report_option_help();
/// A table of the formats, for the value `help`.
std::string report_formats_page();

/// `--fail-on` and `--max-warnings`.
struct Threshold {
  std::optional<Severity> fail_on = Severity::error;  ///< none: never
  std::optional<int> max_warnings;
  bool exit_zero = false;
  bool is_strict = false;  ///< companions that were not compared are failures
};
/// The lowest severity that ends a run with kFindings; none with `--fail-on never`.
std::optional<Severity> least_failure(const Summary& summary, const Threshold& threshold);
/// kDone or kFindings.
ExitCode judge(const Summary& summary, const Threshold& threshold);

}  // namespace smurf::tools
