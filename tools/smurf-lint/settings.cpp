// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/settings.hpp"

#include "base/path.hpp"
#include "base/path_patterns.hpp"
#include "common/input.hpp"

namespace smurf::tools {
namespace {

void append(const std::vector<Spanned<std::string>>& from, std::vector<std::string>& to) {
  for (const Spanned<std::string>& text : from) to.push_back(text.value);
}

std::map<std::string, Severity> values_of(const std::map<std::string, Spanned<Severity>>& levels) {
  std::map<std::string, Severity> values;
  for (const auto& [pattern, level] : levels) values[pattern] = level.value;
  return values;
}

PathRules rules_of(const ConfigPath& path) {
  PathPatterns patterns;
  patterns.add(path.pattern.text.value);
  PathRules rules;
  rules.covers = [patterns, folder = path.pattern.folder](const std::string& file) {
    const std::string inside = path_inside(file, folder);
    return !inside.empty() && patterns.excludes(inside);
  };
  append(path.ignore, rules.ignore);
  rules.severities = values_of(path.severities);
  return rules;
}

}  // namespace

Settings merge(const Config& config, const LintOptions& options) {
  Settings settings;
  RuleSelection& selection = settings.selection;
  selection = options.selection;
  if (selection.select.empty()) append(config.select, selection.select);
  append(config.ignore, selection.ignore);
  if (selection.targets.empty()) {
    for (const auto& target : config.targets) {
      selection.targets.push_back(find_target(target.value));
    }
  }
  for (const auto& [pattern, severity] : values_of(config.severities)) {
    selection.severities.try_emplace(pattern, severity);
  }
  for (const auto& [rule, tolerance] : config.tolerances) {
    selection.tolerances[rule] = tolerance.value;
  }
  for (const ConfigPath& path : config.paths) selection.paths.push_back(rules_of(path));
  settings.packages = options.packages;
  for (const auto& [name, folder] : config.packages) {
    settings.packages.try_emplace(name, folder.value);
  }
  return settings;
}

RunSettings merge_run(const Config& config, const LintOptions& options) {
  RunSettings settings{options.reports, options.threshold, options.baseline, {}};
  if (settings.reports.empty()) {
    for (const Spanned<std::string>& report : config.formats) {
      append_report(settings.reports)(report.value);
    }
  }
  if (settings.reports.empty()) settings.reports.push_back({find_report_format("auto"), {}});
  if (!options.has_fail_on && config.fail_on) settings.threshold.fail_on = config.fail_on->value;
  if (!options.threshold.max_warnings && config.max_warnings) {
    settings.threshold.max_warnings = config.max_warnings->value;
  }
  if (settings.baseline.empty() && config.baseline) {
    settings.baseline = config.baseline->value;
    settings.baseline_place = config.baseline->span;
  }
  return settings;
}

std::string path_inside(const std::string& path, const std::string& folder) {
  const std::string whole = identity(path);
  std::string above = identity(folder);
  if (!above.ends_with('/')) above += '/';
  return whole.starts_with(above) ? whole.substr(above.size()) : std::string();
}

}  // namespace smurf::tools
