// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/settings.hpp"

namespace smurf::tools {

CheckSettings check_settings(const LintOptions& options) {
  CheckSettings settings;
  settings.config = options.config;
  settings.is_isolated = options.isolated;
  for (const std::string_view name : report_format_names()) {
    if (name != kRecords) settings.formats.emplace_back(name);  // only a user asks for them
  }
  settings.selection = options.selection;
  settings.packages = options.packages;
  settings.max_seconds = options.max_seconds;
  settings.xacro = options.xacro;
  settings.heeds_comments = !options.no_ignores;
  settings.heeds_baseline = !options.no_ignores && !options.generate_baseline;
  settings.baseline = options.baseline;
  settings.jobs = static_cast<unsigned>(options.jobs.value_or(0));
  // Only fixes cause further checks.
  settings.remembers =
      (options.fix || options.fix_only || options.diff) && !options.renames_names();
  return settings;
}

void leave_out_below(Severity least, Report& report) {
  std::erase_if(report.diagnostics, [&](const Diagnostic& one) { return one.severity < least; });
  const Summary left = summarize(report.diagnostics);
  report.summary.warnings = left.warnings;
  report.summary.infos = left.infos;
}

RunSettings merge_run(const ReportSettings& report, const LintOptions& options) {
  RunSettings settings{options.reports, options.threshold, report.baseline};
  if (settings.reports.empty()) {
    for (const std::string& format : report.formats) append_report(settings.reports)(format);
  }
  if (settings.reports.empty()) settings.reports.push_back({find_report_format("auto"), {}});
  if (!options.has_fail_on && report.fail_on) settings.threshold.fail_on = report.fail_on->least;
  if (!options.threshold.max_warnings && report.max_warnings) {
    settings.threshold.max_warnings = report.max_warnings;
  }
  return settings;
}

}  // namespace smurf::tools
