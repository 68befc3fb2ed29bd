// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/options.hpp"

#include <algorithm>
#include <set>

#include "base/numbers.hpp"
#include "common/shared_options.hpp"

namespace smurf::tools {
namespace {

constexpr std::pair<std::string_view, Severity> kLevels[] = {
    {"error", Severity::error}, {"warning", Severity::warning}, {"info", Severity::info}};

bool is_pattern(std::string_view pattern) {
  const auto rules = all_rules();
  return std::any_of(rules.begin(), rules.end(),
                     [&](const Rule* rule) { return matches(*rule, pattern); });
}

Setter append_rules(std::vector<std::string>& patterns) {
  return [&patterns](std::string_view value) -> std::optional<std::string> {
    for (const std::string_view pattern : split_items(value)) {
      if (!is_pattern(pattern)) return no_such_rule(pattern);
      patterns.emplace_back(pattern);
    }
    return std::nullopt;
  };
}

Setter set_severity(std::map<std::string, Severity>& severities) {
  return [&severities](std::string_view value) -> std::optional<std::string> {
    for (const std::string_view item : split_items(value)) {
      const std::size_t equals = std::min(item.find('='), item.size());
      const std::string_view pattern = item.substr(0, equals);
      const std::string_view word = item.substr(std::min(equals + 1, item.size()));
      if (equals == item.size()) return "'" + std::string(item) + "' is not ID=LEVEL";
      if (!is_pattern(pattern)) return no_such_rule(pattern);
      const auto* level = std::find_if(std::begin(kLevels), std::end(kLevels),
                                       [&](const auto& one) { return one.first == word; });
      if (level == std::end(kLevels)) {
        return none_of(word, std::vector<std::string_view>{"error", "warning", "info"});
      }
      severities[std::string(pattern)] = level->second;
    }
    return std::nullopt;
  };
}

/// Ids, then names.
std::vector<std::string_view> rule_words() {
  std::vector<std::string_view> words;
  for (const Rule* rule : all_rules()) words.push_back(rule->id);
  for (const Rule* rule : all_rules()) words.push_back(rule->name);
  return words;
}

/// Without duplicates: the report has one row a reader.
Setter append_targets(std::vector<const Reader*>& targets) {
  return [&targets](std::string_view value) -> std::optional<std::string> {
    for (const std::string_view name : split_items(value)) {
      const Reader* reader = find_target(name);
      if (reader == nullptr) return none_of(name, target_names());
      if (std::find(targets.begin(), targets.end(), reader) == targets.end()) {
        targets.push_back(reader);
      }
    }
    return std::nullopt;
  };
}

std::string_view target_help() {
  static const std::string help = [] {
    std::string names;
    for (const std::string_view name : target_names()) {
      names.append(names.empty() ? "" : ", ").append(name);
    }
    return "Judge for these readers, and say what becomes of the files in each: " + names + ".";
  }();
  return help;
}

/// "joint:elbow=elbow_left"; without a known kind, what is before the `=` is all name.
Setter append_renames(std::vector<Rename>& renames) {
  return [&renames](std::string_view value) -> std::optional<std::string> {
    const std::size_t colon = value.find(':');
    Rename rename;
    if (colon != std::string_view::npos) rename.kind = find_name_kind(value.substr(0, colon));
    const std::string_view names = rename.kind ? value.substr(colon + 1) : value;
    const std::size_t equals = names.find('=');
    if (equals == std::string_view::npos || equals == 0) {
      return "'" + std::string(value) + "' is not KIND:NAME=NEW";
    }
    rename.from = names.substr(0, equals);
    rename.to = names.substr(equals + 1);
    renames.push_back(std::move(rename));
    return std::nullopt;
  };
}

Setter set_shard(Shard& shard) {
  return [&shard](std::string_view value) -> std::optional<std::string> {
    const std::size_t slash = value.find('/');
    const auto number = parse_integer(value.substr(0, slash));
    const auto count =
        slash == std::string_view::npos ? std::nullopt : parse_integer(value.substr(slash + 1));
    if (!number || !count || *number < 1 || *number > *count) {
      return "'" + std::string(value) + "' is not K/N with K from 1 to N";
    }
    shard = {static_cast<std::size_t>(*number), static_cast<std::size_t>(*count)};
    return std::nullopt;
  };
}

std::vector<Option> rule_options(LintOptions& options) {
  return {
      {.group = "Rules",
       .name = "select",
       .metavar = "IDS",
       .help = "Only these rules: ids, names or prefixes such as SML3, separated by commas.",
       .suggestions = rule_words,
       .set = append_rules(options.selection.select)},
      {.group = "Rules",
       .name = "ignore",
       .metavar = "IDS",
       .help = "All but these rules.",
       .suggestions = rule_words,
       .set = append_rules(options.selection.ignore)},
      {.group = "Rules",
       .name = "target",
       .metavar = "LIST",
       .help = target_help(),
       .set = append_targets(options.selection.targets)},
      {.group = "Rules",
       .name = "severity",
       .metavar = "ID=LEVEL",
       .help = "Make a rule an error, a warning or an info.",
       .set = set_severity(options.selection.severities)},
      {.group = "Rules",
       .name = "config",
       .metavar = "FILE",
       .help = "Read this configuration. Without it: for each file, the .smurf-lint.yaml in its "
               "folder or the nearest folder above.",
       .set = set_text(options.config)},
      {.group = "Rules",
       .name = "isolated",
       .help = "Read no configuration.",
       .set = set_flag(options.isolated)},
      {.group = "Rules",
       .name = "show-config",
       .metavar = "PATH",
       .help = "Show the configuration that holds for a file or folder, with the origin of each "
               "value, and check nothing.",
       .set = set_text(options.show_config)},
      {.group = "Rules",
       .name = "explain",
       .metavar = "ID",
       .help = "Show why a rule matters and what to do, or what a key (motors.maxEffort) or an "
               "attribute (limit.effort) means, and check nothing.",
       .suggestions = rule_words,
       .set = set_text(options.explain)},
      {.group = "Rules",
       .name = "list-rules",
       .metavar = "FORMAT",
       .may_omit_value = true,
       .help = "List the rules as text or json, and check nothing.",
       .values = {"text", "json"},
       .set =
           [&options](std::string_view value) {
             options.list_rules = value.empty() ? "text" : value;
             return std::optional<std::string>{};
           }},
  };
}

std::vector<Option> ignore_options(LintOptions& options) {
  return {
      {.group = "What may pass",
       .name = "baseline",
       .metavar = "FILE",
       .help = "Let the findings in this file pass, and report new ones only.",
       .set = set_text(options.baseline)},
      {.group = "What may pass",
       .name = "generate-baseline",
       .help = "Write all of today's findings to the baseline; those that are mended go. It is the "
               "FILE of --baseline, else that of a configuration named by --config, else "
               ".smurf-lint-baseline.yaml in the current folder.",
       .set = set_flag(options.generate_baseline)},
      {.group = "What may pass",
       .name = "no-ignores",
       .help = "Report everything, whatever comments (`# smurf-lint: ignore[SML3101] reason`) and "
               "the baseline let pass.",
       .set = set_flag(options.no_ignores)},
  };
}

std::vector<Option> fix_options(LintOptions& options) {
  return {
      {.group = "Fixes",
       .name = "fix",
       .help = "Apply the safe fixes, and report what is left. From standard input, the fixed text "
               "goes to standard output and the report to standard error.",
       .set = set_flag(options.fix)},
      {.group = "Fixes",
       .name = "unsafe-fixes",
       .help = "With --fix or --diff: also fixes that may change what the model means.",
       .set = set_flag(options.unsafe_fixes)},
      {.group = "Fixes",
       .name = "fix-only",
       .help = "Apply fixes, and do not report what is left.",
       .set = set_flag(options.fix_only)},
      {.group = "Fixes",
       .name = "diff",
       .help = "Show what --fix or --rename would change, and change nothing; exit with 1 if that "
               "is anything.",
       .set = set_flag(options.diff)},
      {.group = "Fixes",
       .name = "rename",
       .metavar = "KIND:NAME=NEW",
       .help = "Give a link, joint, motor, material, ... a new name wherever the models and scenes "
               "name it, and report what they come to; may be repeated. KIND: may be left out when "
               "only one thing has the name.",
       .set = append_renames(options.renames)},
  };
}

std::vector<Option> output_options(LintOptions& options) {
  // Every tool has --report; here the report is the result, which ruff and others call --format.
  Option report = report_option("report", options.reports);
  report.help = "The same as --format.";
  return {
      report_option("format", options.reports),
      report,
      output_option(options.output, "Write the report to FILE instead of standard output."),
      {.group = "Output",
       .name = "merge-reports",
       .help = "Each PATH is a JSON report, of a part of the files: write them as one JSON report, "
               "and check nothing.",
       .set = set_flag(options.merge_reports)},
      {.group = "Output",
       .name = "all",
       .help = "Show every finding (full): infos too, and more than three of one rule in a file.",
       .set = set_flag(options.shows_all)},
      {.group = "Output",
       .name = "statistics",
       .help = "Count the findings of each rule instead of listing them (full, concise).",
       .set = set_flag(options.statistics)},
  };
}

std::vector<Option> verdict_options(LintOptions& options) {
  Option fail_on = fail_on_option(options.threshold);
  fail_on.set = [&options, set = fail_on.set](std::string_view value) {
    options.has_fail_on = true;
    return set(value);
  };
  using Level = std::optional<Severity>;
  return {
      {.group = "Verdict",
       .name = "min-severity",
       .metavar = "LEVEL",
       .help = "Leave out what is less severe than this: error, warning or info.",
       .values = {"error", "warning", "info"},
       .set = choose<Level>(
           options.min_severity,
           {{"error", Severity::error}, {"warning", Severity::warning}, {"info", Severity::info}})},
      fail_on,
      {.group = "Verdict",
       .name = "max-warnings",
       .metavar = "N",
       .help = "Exit with 1 when there are more than N warnings.",
       .set = set_number(options.threshold.max_warnings, 0)},
      {.group = "Verdict",
       .name = "exit-zero",
       .help = "Exit with 0 whatever is found; 2 remains 2.",
       .set = set_flag(options.threshold.exit_zero)},
  };
}

std::vector<Option> input_options(LintOptions& options) {
  return {
      {.group = "Input",
       .name = "force-exclude",
       .help =
           "Leave out what `exclude` in the configuration and ignore files name, even when it is "
           "a PATH; for hooks.",
       .set = set_flag(options.force_exclude)},
      {.group = "Input",
       .name = "no-ignore-files",
       .help = "Search folders without regard to .gitignore and .smurf-lintignore.",
       .set = set_flag(options.no_ignore_files)},
      {.group = "Input",
       .name = "only-listed",
       .help = "Leave out YAML files and meshes that no model uses; for hooks, which name every "
               "changed file.",
       .set = set_flag(options.only_listed)},
      {.group = "Input",
       .name = "shard",
       .metavar = "K/N",
       .help = "Check the K-th of N parts of the files; the same parts on every machine.",
       .set = set_shard(options.shard)},
      {.group = "Input",
       .name = "list-files",
       .help = "Show the files that would be checked, and check nothing.",
       .set = set_flag(options.list_files)},
      {.group = "Input",
       .name = "dump-model",
       .metavar = "PATH",
       .help =
           "Write what is read of a model or scene as JSON, each entry with its place, and check "
           "nothing; what keeps it from being read goes to standard error.",
       .set = set_text(options.dump_model)},
  };
}

}  // namespace

Command lint_command(LintOptions& options) {
  Command command;
  command.name = "smurf-lint";
  command.summary = "Checks SMURF models and scenes: what some reader of these files refuses, "
                    "misreads or silently ignores.";
  command.operands = "[PATH]...";
  command.details =
      "A PATH is a .smurf, .smurfs, .smurfa or .urdf file, a scene drawn as .svg, an annotation "
      "file (.yml), a folder to search, or '-' for standard input; without one, the current folder "
      "is searched. A .urdf or .yml file is checked as part of every model nearby that lists it, "
      "and alone when none does; a mesh or texture stands for the models nearby that use it.";
  for (std::vector<Option>& group : std::vector<std::vector<Option>>{
           rule_options(options), ignore_options(options), fix_options(options),
           output_options(options), verdict_options(options), input_options(options)}) {
    std::move(group.begin(), group.end(), std::back_inserter(command.options));
  }
  command.options.push_back(stdin_filename_option(options.stdin_filename));
  command.options.push_back(package_option(options.packages));
  command.options.push_back(allow_outside_option(options.allow_outside));
  command.options.push_back(limit_option(options.limits));
  command.options.push_back(color_option(options.color));
  command.options.push_back(quiet_option(options.quiet, "Show findings only, no summary."));
  command.options.push_back(jobs_option(options.jobs));
  command.set_operand = append_to(options.paths);
  command.examples = {
      {"smurf-lint robots/", "Everything in a folder:"},
      {"smurf-lint --format full --format json=report.json arm.smurf",
       "A model, with a report for programs beside the one for people:"},
      {"smurf-lint --ignore SML19 --severity unknown-joint=warning arm.smurf",
       "Without the rules about portability, and one rule less strict:"},
      {"smurf-lint --target ros,gazebo,mujoco arm.urdf", "For the programs it is meant for:"},
      {"xacro arm.urdf.xacro | smurf-lint --stdin-filename urdf/arm.urdf -",
       "What another program writes:"},
      {"smurf-lint --diff robots/", "What could be fixed without a thought; then with --fix:"},
      {"smurf-lint --rename joint:elbow=elbow_left robots/arm/",
       "Another name, in all files; with --diff to see it first:"},
      {"smurf-lint --baseline old.yaml --generate-baseline robots/",
       "Only new findings from now on; then without --generate-baseline:"},
      {"smurf-lint --shard 2/8 --format json=part-2.json datasets/",
       "One machine of eight; then --merge-reports part-*.json:"},
      {"smurf-lint --explain unknown-joint", "The page of a rule:"},
      {"smurf-lint --explain motors.maxEffort", "What a key means, its unit and its default:"},
      {"smurf-lint --show-config robots/", "What holds there, and where it is said:"},
      {"smurf-lint --dump-model arm.smurf | jq '.model.joints[].limit'",
       "What is read of a model, for programs:"},
  };
  return command;
}

std::optional<std::string> find_conflict(const LintOptions& options) {
  std::set<std::string> places;
  for (const ReportRequest& report : options.reports) {
    std::string place = report.file.empty() ? options.output : report.file;
    if (place.empty()) place = "-";
    if (places.insert(place).second) continue;
    const std::string where = place == "-" ? "standard output" : "'" + place + "'";
    return "two reports go to " + where + "; give one a file of its own: --format " +
           std::string(report.format->name) + "=FILE";
  }
  if (options.isolated && !options.config.empty()) {
    return "--isolated reads no configuration, --config names one";
  }
  if (std::count(options.paths.begin(), options.paths.end(), "-") > 1) {
    return "standard input can be read only once";
  }
  if (options.diff && (options.fix || options.fix_only)) {
    return "--diff changes nothing, so it does not go with --fix";
  }
  if (!options.renames.empty() && (options.fix || options.unsafe_fixes)) {
    return "--rename and --fix are two steps";
  }
  if (!options.renames.empty() && (options.generate_baseline || options.shard.count > 1)) {
    return "--rename needs all files and writes only them, so it goes neither with --shard nor "
           "with --generate-baseline";
  }
  if (options.unsafe_fixes && !options.fix && !options.fix_only && !options.diff) {
    return "--unsafe-fixes goes with --fix, --fix-only or --diff";
  }
  return std::nullopt;
}

std::string no_such_rule(std::string_view id_or_name) {
  return "there is no rule '" + std::string(id_or_name) + "'" +
         did_you_mean(id_or_name, rule_words());
}

}  // namespace smurf::tools
