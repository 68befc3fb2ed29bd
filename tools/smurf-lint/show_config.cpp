// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/show_config.hpp"

#include <algorithm>
#include <utility>

#include "base/files/places.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/edits.hpp"
#include "common/files/input.hpp"
#include "render/printable.hpp"
#include "smurf-lint/lint_plan.hpp"
#include "smurf-lint/settings.hpp"
#include "smurf/check.hpp"
#include "smurf/config.hpp"

namespace smurf::tools {
namespace {

constexpr std::size_t kOriginColumn = 30;

using Entry = std::pair<std::string, std::string>;  ///< a value, as YAML, and its origin
using Entries = std::vector<Entry>;

/// All escapes are inside double quotes, where YAML supports them.
std::string text_of(std::string_view text) { return render::escape(yaml_like("", text)); }
std::string text_of(double number) { return format_number(number); }
std::string text_of(Severity severity) { return std::string(to_string(severity)); }

class Page {
 public:
  explicit Page(const SourceMap& sources) : sources_(sources) {}

  std::string origin(Span span) const {
    const std::uint32_t line = sources_.line_of(span.source, span.begin);
    return render::escape(sources_.path(span.source)) + ":" + std::to_string(line);
  }

  template <class Value>
  Entries list_of(const std::vector<Spanned<Value>>& values) const {
    Entries entries;
    for (const auto& [value, span] : values) entries.emplace_back(text_of(value), origin(span));
    return entries;
  }

  template <class Value>
  Entries map_of(const std::map<std::string, Spanned<Value>>& values) const {
    Entries entries;
    for (const auto& [key, value] : values) {
      entries.emplace_back(text_of(key) + ": " + text_of(value.value), origin(value.span));
    }
    return entries;
  }

  /// "key: value   # origin"
  void line(std::string text, std::string_view origin) {
    text.resize(std::max(text.size() + 2, kOriginColumn), ' ');
    text_.append(text).append("# ").append(origin).append("\n");
  }

  /// A list or mapping below a key; if it is empty, which is the default, the text `nothing`.
  void block(std::string_view indent, std::string_view key, std::string_view mark,
             const Entries& entries, std::string_view nothing = {}) {
    const std::string head = std::string(indent) + std::string(key) + ":";
    if (entries.empty()) {
      if (!nothing.empty()) line(head + " " + std::string(nothing), "default");
      return;
    }
    text_ += head + "\n";
    for (const auto& [value, origin] : entries) {
      line(std::string(indent) + std::string(mark) + value, origin);
    }
  }

  void comment(std::string_view text) {
    text_.append("# ").append(render::escape(text)).append("\n");
  }
  void raw(std::string_view text) { text_ += text; }
  const std::string& text() const { return text_; }

 private:
  const SourceMap& sources_;
  std::string text_;
};

Entries from_option(const std::vector<std::string>& values, std::string_view option) {
  Entries entries;
  for (const std::string& value : values) entries.emplace_back(text_of(value), option);
  return entries;
}

void append(Entries&& from, Entries& to) {
  for (Entry& entry : from) to.push_back(std::move(entry));
}

void show_rules(const Config& config, const LintOptions& options, Page& page) {
  const RuleSelection& given = options.selection;
  page.block("", "select", "- ",
             given.select.empty() ? page.list_of(config.select)
                                  : from_option(given.select, "--select"),
             "[]");
  Entries ignore = from_option(given.ignore, "--ignore");
  append(page.list_of(config.ignore), ignore);
  page.block("", "ignore", "- ", ignore, "[]");

  Entries levels;
  auto severities = config.severities;
  for (const auto& [pattern, severity] : given.severities) {
    levels.emplace_back(text_of(pattern) + ": " + text_of(severity), "--severity");
    severities.erase(pattern);
  }
  append(page.map_of(severities), levels);
  page.block("", "severity", "  ", levels, "{}");
  page.block("", "tolerances", "  ", page.map_of(config.tolerances), "{}");

  Entries targets;
  for (const Reader* reader : given.targets) {
    targets.emplace_back(text_of(reader->name), "--target");
  }
  page.block("", "targets", "- ", targets.empty() ? page.list_of(config.targets) : targets, "[]");

  if (config.paths.empty()) page.block("", "paths", "", {}, "{}");
  if (!config.paths.empty()) page.raw("paths:\n");
  for (const ConfigPath& path : config.paths) {
    page.line("  " + text_of(path.pattern.text.value) + ":", page.origin(path.pattern.text.span));
    page.block("    ", "ignore", "- ", page.list_of(path.ignore));
    page.block("    ", "severity", "  ", page.map_of(path.severities));
  }
}

/// Robots of xacro; each argument has one value or a list of them.
void show_robots(const Config& config, Page& page) {
  if (config.xacro.empty()) return page.block("", "xacro", "", {}, "[]");
  page.raw("xacro:\n");
  for (const ConfigXacro& robot : config.xacro) {
    page.line("- file: " + text_of(robot.file.value), page.origin(robot.file.span));
    if (!robot.arguments.empty()) page.raw("  arguments:\n");
    for (const auto& [name, values] : robot.arguments) {
      std::string list;
      for (const std::string& value : values) list += (list.empty() ? "" : ", ") + text_of(value);
      page.raw("    " + text_of(name.value) + ": " +
               (values.size() == 1 ? list : "[" + list + "]") + "\n");
    }
  }
}

void show_companions(const Config& config, Page& page) {
  if (config.companions.empty()) return page.block("", "companions", "", {}, "[]");
  page.raw("companions:\n");
  for (const ConfigCompanions& one : config.companions) {
    page.line("- robot: " + text_of(one.robot.value), page.origin(one.robot.span));
    page.block("  ", "files", "  - ", page.list_of(one.files), "[]");
  }
}

void show_input(const Config& config, const LintOptions& options, Page& page) {
  Entries exclude;
  for (const ConfigPattern& pattern : config.exclude) {
    exclude.emplace_back(text_of(pattern.text.value), page.origin(pattern.text.span));
  }
  page.block("", "exclude", "- ", exclude, "[]");
  if (options.force_exclude) {
    page.line("force-exclude: true", "--force-exclude");
  } else if (config.force_exclude) {
    page.line(std::string("force-exclude: ") + (config.force_exclude->value ? "true" : "false"),
              page.origin(config.force_exclude->span));
  } else {
    page.line("force-exclude: false", "default");
  }
  Entries packages;
  auto folders = config.packages;
  for (const auto& [name, folder] : options.packages) {
    packages.emplace_back(text_of(name) + ": " + text_of(folder), "--package");
    folders.erase(name);
  }
  append(page.map_of(folders), packages);
  page.block("", "packages", "  ", packages, "{}");
  if (config.section_schemas.empty() && config.entity_schemas.empty()) {
    page.block("", "schemas", "", {}, "{}");
  } else {
    page.raw("schemas:\n");
    page.block("  ", "entities", "  ", page.map_of(config.entity_schemas));
    page.block("  ", "sections", "  ", page.map_of(config.section_schemas));
  }
  show_robots(config, page);
  show_companions(config, page);
}

std::string name_of(const ReportRequest& report) {
  std::string name(report.format->name);
  return report.file.empty() ? name : name + "=" + report.file;
}

void show_run(const Config& config, const RunSettings& run, const LintOptions& options,
              Page& page) {
  Entries formats;
  for (const ReportRequest& report : options.reports) {
    formats.emplace_back(text_of(name_of(report)), "--format");
  }
  page.block("", "format", "- ", formats.empty() ? page.list_of(config.formats) : formats, "auto");

  const auto& level = run.threshold.fail_on;
  page.line("fail-on: " + (level ? text_of(*level) : "never"),
            options.has_fail_on ? "--fail-on"
            : config.fail_on    ? page.origin(config.fail_on->span)
                                : "default");
  const auto& most = run.threshold.max_warnings;
  page.line("max-warnings: " + (most ? std::to_string(*most) : "null"),
            options.threshold.max_warnings ? "--max-warnings"
            : config.max_warnings          ? page.origin(config.max_warnings->span)
                                           : "default: any number");
  page.line("baseline: " + (run.baseline.empty() ? "null" : text_of(run.baseline)),
            !options.baseline.empty() ? "--baseline"
            : config.baseline         ? page.origin(config.baseline->span)
                                      : "default");
}

}  // namespace

ExitCode show_config(const LintOptions& options) {
  ConfinedFiles disk;
  confine_to_inputs(disk, options);
  const InputFiles files(disk);
  if (!places::exists(options.show_config)) {
    complain(kSmurfLint, "there is no '" + options.show_config + "'");
    return kFailed;
  }
  const std::string path = find_config(options.show_config, options, files);
  if (const auto reason = path.empty() ? std::nullopt : why_unreadable(path, files)) {
    complain(kSmurfLint, "cannot read '" + path + "': " + *reason);
    return kFailed;
  }
  SourceMap sources;
  DiagnosticSink reported_below;
  const Config config = path.empty() ? Config{}
                                     : read_config(path, sources, files, reported_below, {},
                                                   origin_of_config(options));
  // Checking no files reports mistakes in the configuration.
  Session session(files, options.limits);
  Plan nothing;
  nothing.configs.push_back(path);
  CheckSettings settings = check_settings(options);
  settings.heeds_baseline = false;
  const Report report = session.check(nothing, settings);
  const RunSettings run = merge_run(report.settings, options);
  Page page(sources);
  page.comment("for " + options.show_config + ": " + (path.empty() ? "no configuration" : path));
  show_rules(config, options, page);
  show_input(config, options, page);
  show_run(config, run, options, page);
  if (!keeps_inputs(kSmurfLint, files, std::span(&options.output, 1))) return kFailed;
  if (!write_output(kSmurfLint, options.output, page.text())) return kFailed;

  for (const Diagnostic& one : report.diagnostics) {
    write_error(render_concise(one, session.sources(), style_for(Stream::error, options.color)));
  }
  return judge(report.summary, run.threshold);
}

}  // namespace smurf::tools
