// SPDX-License-Identifier: BSD-3-Clause
// smurf-lint: checks SMURF models and scenes.
#include "smurf-lint/check.hpp"
#include "smurf-lint/options.hpp"

using namespace smurf;
using namespace smurf::tools;

namespace {

constexpr std::string_view kTool = "smurf-lint";

TextStyle style_of(const LintOptions& options, const std::string& file) {
  if (file.empty() || file == "-") return style_for(Stream::output, options.color);
  return {options.color == ColorChoice::always, 0};
}

ExitCode write_text(const LintOptions& options, std::string_view text) {
  return write_output(kTool, options.output, text) ? kDone : kFailed;
}

ExitCode explain(const LintOptions& options) {
  const Rule* rule = find_rule(options.explain);
  if (rule == nullptr) {
    complain(kTool, no_such_rule(options.explain));
    return kFailed;
  }
  return write_text(options, render_rule(*rule, style_of(options, options.output)));
}

ExitCode list_rules(const LintOptions& options) {
  if (options.list_rules == "json") return write_text(options, render_rule_list_json(all_rules()));
  return write_text(options, render_rule_list(all_rules(), style_of(options, options.output)));
}

ExitCode write_reports(const LintOptions& options, const Checked& checked) {
  std::vector<ReportRequest> reports = options.reports;
  if (reports.empty()) reports.push_back({find_report_format("full"), {}});
  const Results results{.diagnostics = checked.diagnostics,
                        .sources = checked.sources,
                        .summary = checked.summary,
                        .tool = kTool,
                        .quiet = options.quiet,
                        .counts_only = options.statistics};
  ExitCode code = kDone;
  for (const ReportRequest& report : reports) {
    const std::string& file = report.file.empty() ? options.output : report.file;
    const std::string text = report.format->render(results, style_of(options, file));
    if (!write_output(kTool, file, text)) code = kFailed;
  }
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  prepare_streams();
  LintOptions options;
  if (const auto code = parse_command_line(lint_command(options), argc, argv)) return *code;
  if (const auto conflict = find_conflict(options)) {
    complain(kTool, *conflict);
    return kFailed;
  }
  if (!options.explain.empty()) return explain(options);
  if (!options.list_rules.empty()) return list_rules(options);

  const Checked checked = check(options);
  const ExitCode written = write_reports(options, checked);
  if (checked.has_failed || written != kDone) return kFailed;
  return judge(checked.summary, options.threshold);
}
