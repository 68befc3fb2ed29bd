// SPDX-License-Identifier: BSD-3-Clause
#include "common/cli/report.hpp"

#include <algorithm>
#include <cstdlib>

#include "base/files/system.hpp"
#include "base/text/counted.hpp"
#include "base/text/lists.hpp"
#include "plan/repository.hpp"

namespace smurf::tools {
namespace {

/// A table of the ten most frequent rules among the findings that the report shows; empty for 50
/// findings or fewer.
std::string most_frequent(const Results& results, const TextStyle& style) {
  constexpr std::size_t kMany = 50;
  constexpr std::size_t kRules = 10;
  std::vector<Diagnostic> shown;  // without texts, which the table does not need
  for (const Diagnostic& one : results.diagnostics) {
    if (!is_shown(one, results.overview)) continue;
    Diagnostic& copy = shown.emplace_back();
    copy.rule = one.rule;
    copy.severity = one.severity;
  }
  if (shown.size() <= kMany) return {};
  return "The most frequent findings:\n" + render_statistics(shown, style, kRules) + "\n";
}

/// A line that says that less severe findings are not shown.
std::string hidden(const Results& results) {
  const Severity least = results.overview.least;
  if (results.counts_only || least == Severity::info) return {};
  const auto infos = static_cast<std::size_t>(std::count_if(
      results.diagnostics.begin(), results.diagnostics.end(), [&](const Diagnostic& one) {
        return one.severity == Severity::info && !is_shown(one, results.overview);
      }));
  if (infos == 0) return {};
  return counted(infos, "info is", "infos are") + " not shown; --min-severity info shows " +
         (infos == 1 ? "it" : "them") + "\n";
}

/// A line that says where to read more about the worst finding.
std::string pointer_to_page(const Results& results) {
  const auto worst = std::max_element(
      results.diagnostics.begin(), results.diagnostics.end(),
      [](const Diagnostic& a, const Diagnostic& b) { return a.severity < b.severity; });
  if (worst == results.diagnostics.end() || !is_shown(*worst, results.overview)) return {};
  return "\nsmurf-lint --explain " + std::string(worst->rule->id) + ", or " +
         rule_address(*worst->rule, kSite) + "\n";
}

/// The format for people, which ends with a summary and the verdicts of the targets.
std::string full(const Results& results, const TextStyle& style) {
  std::string out;
  if (results.counts_only) {
    out = render_statistics(results.diagnostics, style);
    if (!out.empty()) out += "\n";
  } else {
    if (!results.quiet) out = render_fleet(results.robots);
    out += render_overview(results.diagnostics, results.sources, results.overview, style);
  }
  if (results.quiet) return out;
  if (!results.counts_only) out += most_frequent(results, style);
  out += render_summary(results.summary, style) + hidden(results) + results.remarks;
  if (!results.targets.empty()) out += "\n";
  out += render_targets(results.targets, results.sources, style);
  const std::string robots = render_robots(results.robots, results.targets, style);
  if (!robots.empty()) out += "\n" + robots;
  return results.counts_only ? out : out + pointer_to_page(results);
}

std::string concise(const Results& results, const TextStyle& style) {
  if (results.counts_only) return render_statistics(results.diagnostics, style);
  std::string out;
  for (const Diagnostic& diagnostic : results.diagnostics) {
    out += render_concise(diagnostic, results.sources, style);
  }
  return out;
}

std::string json(const Results& results, const TextStyle&) {
  return render_json(results.diagnostics, results.sources, results.summary,
                     {results.tool, kVersion}, results.targets);
}

/// The findings that the format for people shows. Code hosts show each finding beside a change of
/// somebody, so they get no infos that nobody asked for.
class ShownFindings {
 public:
  explicit ShownFindings(const Results& results) : shown_(results.diagnostics) {
    const auto is_hidden = [&](const Diagnostic& one) {
      return one.severity < results.overview.least;
    };
    if (std::none_of(shown_.begin(), shown_.end(), is_hidden)) return;
    std::remove_copy_if(shown_.begin(), shown_.end(), std::back_inserter(copies_), is_hidden);
    shown_ = copies_;
  }
  std::span<const Diagnostic> get() const { return shown_; }

 private:
  std::vector<Diagnostic> copies_;
  std::span<const Diagnostic> shown_;
};

std::string jsonl(const Results& results, const TextStyle&) {
  const SourceMap& sources = results.sources;
  return render_record({.path = sources.size() == 0 ? "" : sources.path(SourceId{0}),
                        .diagnostics = results.diagnostics,
                        .summary = results.summary,
                        .targets = results.targets},
                       sources);
}

std::string sarif(const Results& results, const TextStyle&) {
  const ShownFindings shown(results);
  return render_sarif(shown.get(), results.sources, all_rules(), {results.tool, kVersion}, kSite,
                      in_repository(), results.summary);
}

std::string github(const Results& results, const TextStyle&) {
  const ShownFindings shown(results);
  return render_github(shown.get(), results.sources, in_repository());
}

std::string gitlab(const Results& results, const TextStyle&) {
  const ShownFindings shown(results);
  return render_gitlab(shown.get(), results.sources, in_repository());
}

std::string junit(const Results& results, const TextStyle&) {
  return render_junit(results.diagnostics, results.sources, {results.tool, kVersion},
                      results.least_failure);
}

std::string html(const Results& results, const TextStyle&) {
  const std::string picture = results.picture ? results.picture() : "";
  return render_html(results.diagnostics, results.sources, results.summary,
                     {results.tool, kVersion}, results.targets,
                     {.remarks = results.remarks, .picture = picture, .robots = results.robots});
}

/// The format for the log of a CI run: GitHub shows lines in its own format as marks in the files.
std::string automatic(const Results& results, const TextStyle& style) {
  const char* variable = std::getenv("GITHUB_ACTIONS");
  const bool is_github = variable != nullptr && std::string_view(variable) == "true";
  return is_github ? github(results, style) : full(results, style);
}

constexpr ReportFormat kFormats[] = {
    {"full", "source lines with marks, and a summary", full},
    {"concise", "one line per finding", concise},
    {"json", "for programs", json},
    {kRecords, "for data sets: a line of JSON for each robot", jsonl},
    {"sarif", "for code scanning and editors", sarif},
    {"github", "annotations of a workflow", github},
    {"gitlab", "a code quality report", gitlab},
    {"junit", "test cases, one per file", junit},
    {"html", "a page for a browser, to search and filter", html},
    {"auto", "github in a GitHub workflow, otherwise full (the default)", automatic},
};

}  // namespace

const ReportFormat* find_report_format(std::string_view name) {
  const auto* found = std::find_if(std::begin(kFormats), std::end(kFormats),
                                   [&](const ReportFormat& format) { return format.name == name; });
  return found == std::end(kFormats) ? nullptr : found;
}

std::vector<std::string_view> report_format_names() {
  std::vector<std::string_view> names;
  for (const ReportFormat& format : kFormats) names.push_back(format.name);
  return names;
}

std::string_view report_option_help() {
  static const std::string help = [] {
    return "Choose the format of the report: " + listed(report_format_names()) +
           "; `help` describes them. May be repeated, with a FILE for all but one.";
  }();
  return help;
}

std::string report_formats_page() {
  std::string page = "Formats of reports:\n\n";
  for (const ReportFormat& format : kFormats) {
    constexpr std::size_t kWidth = 10;
    page.append("  ").append(format.name).append(kWidth - format.name.size(), ' ');
    page.append(format.help).append("\n");
  }
  return page;
}

Setter append_report(std::vector<ReportRequest>& requests) {
  return [&requests](std::string_view value) -> std::optional<std::string> {
    const std::size_t equals = value.find('=');
    const std::string_view name = value.substr(0, equals);
    const ReportFormat* format = find_report_format(name);
    if (format == nullptr) {
      return none_of(name, report_format_names());
    }
    ReportRequest request{format, {}};
    if (equals != std::string_view::npos) {
      request.file = sys::from_user(value.substr(equals + 1));
      if (request.file.empty()) return "there is no file name after '='";
    }
    requests.push_back(std::move(request));
    return std::nullopt;
  };
}

std::optional<Severity> least_failure(const Summary& summary, const Threshold& threshold) {
  const bool too_many = threshold.max_warnings &&
                        summary.warnings > static_cast<std::size_t>(*threshold.max_warnings);
  if (!too_many) return threshold.fail_on;
  return std::min(threshold.fail_on.value_or(Severity::warning), Severity::warning);
}

ExitCode judge(const Summary& summary, const Threshold& threshold) {
  if (threshold.exit_zero) return kDone;
  if (threshold.is_strict && !summary.not_compared.empty()) return kFindings;
  const std::size_t by_severity[] = {summary.infos, summary.warnings, summary.errors};
  if (const std::optional<Severity> least = least_failure(summary, threshold)) {
    for (auto i = static_cast<std::size_t>(*least); i < 3; ++i) {
      if (by_severity[i] > 0) return kFindings;
    }
  }
  return kDone;
}

}  // namespace smurf::tools
