// SPDX-License-Identifier: BSD-3-Clause
#include "check/group.hpp"

#include <algorithm>
#include <tuple>

#include "base/files/canonical_paths.hpp"
#include "base/files/path_patterns.hpp"

namespace smurf {
namespace {

void append(const std::vector<Spanned<std::string>>& from, std::vector<std::string>& to) {
  for (const Spanned<std::string>& text : from) to.push_back(text.value);
}

std::map<std::string, Severity> values_of(const std::map<std::string, Spanned<Severity>>& levels) {
  std::map<std::string, Severity> values;
  for (const auto& [pattern, level] : levels) values[pattern] = level.value;
  return values;
}

PathRules rules_of(const ConfigPath& path, const CanonicalPaths& paths,
                   const std::shared_ptr<PathChecks>& checks) {
  PathPatterns patterns;
  patterns.add(path.pattern.text.value);
  const std::string folder = identity(path.pattern.folder, paths);
  PathRules rules;
  rules.covers = [patterns, &paths, checks, folder](const std::string& file) {
    if (!checks->take(1)) return false;
    const std::string inside = path_inside(file, folder, paths);
    if (inside.empty()) return false;
    std::uint64_t steps = 0;
    const bool is_covered = patterns.excludes(inside, &steps);
    return checks->take(steps / PathPatterns::kStepsOfCheck) && is_covered;
  };
  append(path.ignore, rules.ignore);
  rules.severities = values_of(path.severities);
  return rules;
}

void merge(const CheckSettings& settings, const CanonicalPaths& paths, CheckGroup& group) {
  const Config& config = group.config;
  RuleSelection& selection = group.selection;
  selection = settings.selection;
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
  for (const ConfigPath& path : config.paths) {
    selection.paths.push_back(rules_of(path, paths, group.path_checks));
  }
  group.packages = settings.packages;
  for (const auto& [name, folder] : config.packages) {
    group.packages.try_emplace(name, folder.value);
  }
  for (const ConfigCompanions& one : config.companions) {
    append(one.files, group.ties.emplace_back(CompanionTie{one.robot.value, {}}).files);
  }
  group.settings = settings;
}

}  // namespace

CheckGroups read_configurations(const std::vector<std::string>& paths,
                                const CheckSettings& settings, const FileReader& files,
                                SourceMap& sources) {
  CheckGroups groups;
  const std::vector<std::string_view> formats(settings.formats.begin(), settings.formats.end());
  for (const std::string& path : paths) {
    CheckGroup& group = groups.emplace_back();
    DiagnosticSink sink;
    const ConfigOrigin origin = settings.config.empty() ? ConfigOrigin::found : ConfigOrigin::named;
    if (!path.empty()) group.config = read_config(path, sources, files, sink, formats, origin);
    group.found = sink.take();
  }
  return groups;
}

void merge(const CheckSettings& settings, const CanonicalPaths& paths, CheckGroups& groups) {
  const auto checks = std::make_shared<PathChecks>();
  for (CheckGroup& group : groups) {
    group.path_checks = checks;
    merge(settings, paths, group);
  }
}

ReportSettings report_settings_of(const CheckGroup& group) {
  const Config& config = group.config;
  ReportSettings settings;
  append(config.formats, settings.formats);
  if (config.fail_on) settings.fail_on = FailOn{config.fail_on->value};
  if (config.max_warnings) settings.max_warnings = config.max_warnings->value;
  settings.baseline = group.settings.baseline;
  if (settings.baseline.empty() && config.baseline) settings.baseline = config.baseline->value;
  return settings;
}

std::vector<const Reader*> targets_of(const CheckGroups& groups) {
  std::vector<const Reader*> all;
  for (const CheckGroup& group : groups) {
    for (const Reader* target : group.selection.targets) {
      if (std::find(all.begin(), all.end(), target) == all.end()) all.push_back(target);
    }
  }
  return all;
}

bool is_same(const CheckSettings& a, const CheckSettings& b) {
  const auto values = [](const CheckSettings& one) {
    const RuleSelection& rules = one.selection;
    return std::tie(one.config, one.is_isolated, one.formats, rules.select, rules.ignore,
                    rules.severities, rules.targets, rules.tolerances, one.packages,
                    one.package_folders, one.opens_meshes, one.heeds_comments, one.heeds_baseline,
                    one.baseline, one.max_seconds);
  };
  // Functions cannot be compared.
  return a.selection.paths.empty() && b.selection.paths.empty() && values(a) == values(b);
}

std::vector<std::vector<CompanionTie>> ties_of(const CheckGroups& groups) {
  std::vector<std::vector<CompanionTie>> all;
  for (const CheckGroup& group : groups) all.push_back(group.ties);
  return all;
}

}  // namespace smurf
