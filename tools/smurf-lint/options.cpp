// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/options.hpp"

#include <algorithm>
#include <set>

#include "ast/format.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/did_you_mean.hpp"
#include "common/cli/shared_options.hpp"
#include "render/wrap.hpp"
#include "smurf-lint/records.hpp"
#include "smurf-lint/rename_all.hpp"
#include "smurf-lint/show_collisions.hpp"
#include "smurf-lint/show_orders.hpp"

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
        // Other linters know the level `off`.
        return none_of(word, std::vector<std::string_view>{"error", "warning", "info"}) +
               (word == "off" ? "; to switch it off: --ignore " + std::string(pattern) : "");
      }
      severities[std::string(pattern)] = level->second;
    }
    return std::nullopt;
  };
}

std::vector<std::string_view> ids_and_names() { return rule_words(); }

std::vector<std::string_view> rule_ids() {
  std::vector<std::string_view> ids;
  for (const Rule* rule : all_rules()) ids.push_back(rule->id);
  return ids;
}

std::string_view target_help() {
  static const std::string help = [] {
    std::string names, releases;
    for (const std::string_view name : target_names()) {
      std::string& list = name.find(':') == std::string_view::npos ? names : releases;
      list.append(list.empty() ? "" : ", ").append(name);
    }
    return "Judge the files for these readers, and report whether each loads them: " + names +
           ". Without a release, the oldest one that its developers support is meant, and a line says where others differ. Releases: " +
           releases + ".";
  }();
  return help;
}

/// The text of `--target help`: a target and its releases a line.
std::string targets_page() {
  std::string page = "Targets, with what they stand for and their releases:\n\n";
  constexpr std::size_t kIndent = 15;
  for (const Reader* reader : all_readers()) {
    if (!reader->is_target) continue;
    std::string head = "  " + std::string(reader->name);
    head.resize(kIndent, ' ');
    std::string text(reader->title);
    for (const auto& releases : {reader->earlier, reader->releases}) {
      for (const Reader* release : releases) text += ", " + std::string(release->name);
    }
    page += head + render::wrap(text, kIndent, 80).substr(kIndent);
  }
  return page + "\nWhat each of them does: " + std::string(kSite) + "/readers/\n";
}

Setter set_inertia(LintOptions& options) {
  return [&options](std::string_view value) -> std::optional<std::string> {
    const auto source = parse_inertia_source(value.empty() ? "mass" : value);
    if (!source) {
      return "'" + std::string(value) + "' is not mass, mesh, box, nearest or density:VALUE";
    }
    options.fix_inertia = true;
    options.inertia = *source;
    return std::nullopt;
  };
}

std::vector<Option> rule_options(LintOptions& options) {
  return {
      {.group = "Rules",
       .name = "select",
       .metavar = "IDS",
       .help = "Check only these rules: ids, names or prefixes such as SML3, separated by commas.",
       .suggestions = ids_and_names,
       .set = append_rules(options.selection.select)},
      {.group = "Rules",
       .name = "ignore",
       .metavar = "IDS",
       .help = "Check all but these rules.",
       .suggestions = ids_and_names,
       .set = append_rules(options.selection.ignore)},
      {.group = "Rules",
       .name = "target",
       .metavar = "LIST",
       .help = target_help(),
       .suggestions = target_names,
       .help_page = targets_page,
       .set = append_targets(options.selection.targets)},
      {.group = "Rules",
       .name = "severity",
       .metavar = "ID=LEVEL",
       .help = "Report a rule as error, warning or info.",
       .suggestions = rule_ids,
       .levels = {"error", "warning", "info"},
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
       .name = "init",
       .help = "Look at a folder, by default this one, and write a configuration for it; in a git "
               "repository also a pre-commit hook and a workflow. Replaces no file.",
       .set = set_flag(options.init)},
      {.group = "Rules",
       .name = "show-config",
       .metavar = "PATH",
       .help = "Show the configuration that applies to a file or folder, with the origin of each "
               "value, and check nothing.",
       .set = set_text(options.show_config)},
      {.group = "Rules",
       .name = "explain",
       .metavar = "WHAT",
       .help =
           "Explain a rule (SML3101, unknown-joint), list the rules of a family (SML31), list the "
           "keys of a section (motors, entity), or explain a key (motors.maxEffort) or an "
           "attribute (limit.effort), and check nothing.",
       .suggestions = explained_words,
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
      {.group = "Suppressing findings",
       .name = "baseline",
       .metavar = "FILE",
       .help = "Report only findings that are not recorded in this file.",
       .set = set_text(options.baseline)},
      {.group = "Suppressing findings",
       .name = "generate-baseline",
       .help =
           "Record all current findings in the baseline; fixed ones are removed. The baseline is "
           "the FILE of --baseline, else that of a configuration named by --config, else "
           ".smurf-lint-baseline.yaml in the current folder.",
       .set = set_flag(options.generate_baseline)},
      {.group = "Suppressing findings",
       .name = "no-ignores",
       .help = "Also report findings that comments (`# smurf-lint: ignore[SML3101] reason`) or "
               "the baseline suppress.",
       .set = set_flag(options.no_ignores)},
  };
}

std::vector<Option> fix_options(LintOptions& options) {
  return {
      {.group = "Fixes",
       .name = "fix",
       .help =
           "Apply the safe fixes of the findings that are shown (of infos only with --min-severity "
           "info), and report the remaining findings. From standard input, the fixed text "
           "goes to standard output and the report to standard error.",
       .set = set_flag(options.fix)},
      {.group = "Fixes",
       .name = "unsafe-fixes",
       .help = "With --fix or --diff: include fixes that may change the meaning of the model.",
       .set = set_flag(options.unsafe_fixes)},
      {.group = "Fixes",
       .name = "fix-only",
       .help = "Apply fixes without reporting the remaining findings.",
       .set = set_flag(options.fix_only)},
      {.group = "Fixes",
       .name = "diff",
       .help =
           "Show what --fix, --fix-inertia or --rename would change, without changing it; exit with "
           "1 if there would be changes.",
       .set = set_flag(options.diff)},
      {.group = "Fixes",
       .name = "fix-inertia",
       .metavar = "FROM",
       .may_omit_value = true,
       .help = "Write other inertias for those that no body, or not this one, can have: of the "
               "shapes with the written mass (mass, the default), only of closed shapes (mesh), of "
               "the box around them (box), of the shapes with a density in kg/m3, which also gives "
               "the mass (density:VALUE), or the nearest possible one (nearest). Each change is "
               "explained on standard error.",
       .set = set_inertia(options)},
      {.group = "Fixes",
       .name = "rename",
       .metavar = "KIND:NAME=NEW",
       .help =
           "Rename a link, joint, motor, material, ... in all files of the models and scenes, and "
           "check the result; may be repeated. KIND: may be left out when the name is unique. Names "
           "of xacro: macro, property, argument, parameter:MACRO.NAME and block:MACRO.NAME; the "
           "robots stay as they are.",
       .set = append_renames(options)},
      {.group = "Fixes",
       .name = "force",
       .help = "Rename even if other files still contain the old name afterwards.",
       .set = set_flag(options.is_forced)},
  };
}

std::vector<Option> output_options(LintOptions& options) {
  return {
      // Converters call this --report, because their --format is the format of the result.
      report_option("format", options.reports),
      output_option(options.output, "Write the report to FILE instead of standard output."),
      {.group = "Output",
       .name = "all",
       .help = "With the format full: show all findings, including infos and more than three per "
               "rule and file.",
       .set = set_flag(options.shows_all)},
      {.group = "Output",
       .name = "watch",
       .help = "Check again after each change of a file, until Ctrl-C.",
       .set = set_flag(options.watch)},
      open_option(options.opens),
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
      {.group = "Output",
       .name = "min-severity",
       .metavar = "LEVEL",
       .help = "Report only findings of this severity or above: error, warning or info.",
       .values = {"error", "warning", "info"},
       .set = choose<Level>(
           options.min_severity,
           {{"error", Severity::error}, {"warning", Severity::warning}, {"info", Severity::info}})},
      fail_on,
      {.group = "Exit code",
       .name = "max-warnings",
       .metavar = "N",
       .help = "Exit with 1 on more than N warnings.",
       .set = set_number(options.threshold.max_warnings, 0)},
      {.group = "Exit code",
       .name = "strict",
       .help = "Exit with 1 if a file of ROS was seen, and not compared with a robot.",
       .set = set_flag(options.threshold.is_strict)},
      {.group = "Exit code",
       .name = "exit-zero",
       .help = "Exit with 0 even when there are findings; failures still exit with 2.",
       .set = set_flag(options.threshold.exit_zero)},
  };
}

std::vector<Option> input_options(LintOptions& options) {
  return {
      {.group = "Input",
       .name = "force-exclude",
       .help = "Apply `exclude` of the configuration and ignore files to every PATH as well; for "
               "hooks.",
       .set = set_flag(options.force_exclude)},
      {.group = "Input",
       .name = "no-ignore-files",
       .help = "Ignore .gitignore and .smurf-lintignore when searching folders.",
       .set = set_flag(options.no_ignore_files)},
      {.group = "Input",
       .name = "only-listed",
       .help = "Skip YAML files and meshes that no model uses; for hooks, which name every changed "
               "file.",
       .set = set_flag(options.only_listed)},
      {.group = "Input",
       .name = "list-files",
       .help = "Show the files that would be checked, and check nothing.",
       .set = set_flag(options.list_files)},
      {.group = "Input",
       .name = "dump-model",
       .metavar = "PATH",
       .help = "Write a model or scene as JSON, each entry with its place in the files, and check "
               "nothing; errors that prevent reading it go to standard error.",
       .set = set_text(options.dump_model)},
      {.group = "Input",
       .name = "masses",
       .metavar = "PATH",
       .help = "Show the links of a model with mass, volume of the shapes, density, radius of "
               "gyration and verdict, and check nothing else.",
       .set = set_text(options.masses)},
      joint_order_option(options),
      collision_matrix_option(options),
      samples_option(options),
      {.group = "Input",
       .name = "csv",
       .help = "With --masses: write comma-separated values with all digits.",
       .set = set_flag(options.csv)},
  };
}

}  // namespace

Setter append_targets(std::vector<const Reader*>& targets) {
  return [&targets](std::string_view value) -> std::optional<std::string> {
    const std::vector<std::string_view> names = split_items(value);
    if (names.empty()) return "the list names no target (`--target help` lists them)";
    for (const std::string_view name : names) {
      const Reader* reader = find_target(name);
      if (reader == nullptr) {
        return "there is no target '" + std::string(name) + "'" +
               did_you_mean(name, target_names()) + " (`--target help` lists them)";
      }
      if (std::find(targets.begin(), targets.end(), reader) == targets.end()) {
        targets.push_back(reader);
      }
    }
    return std::nullopt;
  };
}

std::vector<std::string_view> explained_words() {
  std::vector<std::string_view> words = rule_words();
  for (const FormatPart& part : describe_format()) words.push_back(part.name);
  return words;
}

Command lint_command(LintOptions& options) {
  Command command;
  command.name = "smurf-lint";
  command.summary =
      "Finds what programs refuse, misread or silently ignore in robots: URDF, xacro, SRDF, "
      "ros2_control, controllers, MoveIt, SMURF models and scenes.";
  command.operands = "[PATH]... [NAME:=VALUE]...";
  command.details =
      "A PATH is a folder to search, a .urdf, .xacro, .srdf, .smurf, .smurfs or .smurfa file, a scene "
      "drawn as .svg, a YAML file of a robot (annotations, controllers, MoveIt), or '-' for standard "
      "input; without one, the current folder is searched. A .urdf or .yml file is checked as part of every nearby model that lists it, "
      "or alone if no model lists it. For a mesh or texture, the nearby models that use it are "
      "checked.";
  for (std::vector<Option>& group : std::vector<std::vector<Option>>{
           rule_options(options), ignore_options(options), fix_options(options),
           output_options(options), record_options(options), verdict_options(options),
           input_options(options)}) {
    std::move(group.begin(), group.end(), std::back_inserter(command.options));
  }
  for (Option& option : std::vector<Option>{
           stdin_filename_option(options.stdin_filename), package_option(options.packages),
           xacro_env_option(options.xacro.environment), allow_outside_option(options.allow_outside),
           limit_option(options.limits), max_seconds_option(options.max_seconds),
           color_option(options.color), jobs_option(options.jobs),
           quiet_option(options.quiet, "Show findings only, no summary.")}) {
    command.options.push_back(std::move(option));
  }
  command.set_operand = [&options](std::string_view value) -> std::optional<std::string> {
    if (!take_xacro_argument(value, options.xacro)) options.paths.emplace_back(value);
    return std::nullopt;
  };
  command.examples = {
      {"smurf-lint robots/", "Check everything in a folder:"},
      {"smurf-lint --target ros,gazebo,mujoco arm.urdf",
       "Check a file for the programs that will load it:"},
      {"smurf-lint --format full --format json=report.json arm.smurf",
       "Write a report for programs beside the one for people:"},
      {"smurf-lint --open arm.smurf", "See the findings on the robot, in the browser:"},
      {"smurf-lint --ignore SML19 --severity unknown-joint=warning arm.smurf",
       "Skip the rules about portability, and lower the severity of one rule:"},
      {"smurf-lint arm.urdf.xacro side:=left", "Check a xacro file, with its arguments:"},
      {"python3 make_arm.py | smurf-lint --stdin-filename urdf/arm.urdf -",
       "Check the output of another program:"},
      {"smurf-lint --diff robots/", "Preview the safe fixes (--fix applies them):"},
      {"smurf-lint --rename joint:elbow=elbow_left robots/arm/",
       "Rename a joint in all files (--diff previews it):"},
      {"smurf-lint --baseline old.yaml --generate-baseline robots/",
       "Record the current findings, to report only new ones later:"},
      {"smurf-lint --init", "Set up this folder: configuration, pre-commit hook, workflow:"},
      {"smurf-lint --explain unknown-joint", "Explain a rule:"},
      {"smurf-lint --explain motors", "List the keys of a section:"},
      {"smurf-lint --explain motors.maxEffort", "Explain a key:"},
      {"smurf-lint --show-config robots/", "Show which settings apply, and where they are set:"},
      {"smurf-lint --fix-inertia --diff robot.urdf", "Show inertias that fit the shapes:"},
      {"smurf-lint --masses robot.urdf", "Compare the masses of a robot with its shapes:"},
      {"smurf-lint --joint-order mujoco,pinocchio robot.urdf",
       "Compare the orders of joints of two programs:"},
      {"smurf-lint --dump-model arm.smurf | jq '.model.joints[].limit'",
       "Read a model from another program:"},
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
    return "two reports go to " + where + "; give one a separate file: --format " +
           std::string(report.format->name) + "=FILE";
  }
  if (const auto conflict = records_conflict(options)) return conflict;
  if (options.isolated && !options.config.empty()) {
    return "--isolated and --config exclude each other";
  }
  if (std::count(options.paths.begin(), options.paths.end(), "-") > 1) {
    return "standard input can be read only once";
  }
  if (options.diff && (options.fix || options.fix_only)) {
    return "--diff shows what --fix would change; leave out " +
           std::string(options.fix ? "--fix" : "--fix-only");
  }
  if (!options.renames.empty() && !options.xacro_renames.empty()) {
    return "--rename changes names of xacro and names of robots one after the other";
  }
  if (options.renames_names() && (options.fix || options.unsafe_fixes)) {
    return "--rename and --fix cannot be combined";
  }
  if (options.renames_names() && options.generate_baseline) {
    return "--rename and --generate-baseline cannot be combined";
  }
  if (options.fix_inertia && (options.fix || options.unsafe_fixes || options.renames_names() ||
                              options.generate_baseline)) {
    return "--fix-inertia cannot be combined with --fix, --rename or --generate-baseline";
  }
  if (options.watch && (options.fix || options.fix_only || options.diff || options.fix_inertia ||
                        options.renames_names() || options.generate_baseline)) {
    return "--watch only reports; apply fixes in another run";
  }
  if (options.watch && std::count(options.paths.begin(), options.paths.end(), "-") > 0) {
    return "--watch needs files, not standard input";
  }
  if (options.watch && options.opens) return "--watch --open: use smurf-view --watch";
  if (options.init && options.paths.size() > 1) return "--init sets up one folder";
  if (options.csv && options.masses.empty()) return "--csv needs --masses";
  if (options.samples && options.collision_matrix.empty()) {
    return "--samples needs --collision-matrix";
  }
  if (options.unsafe_fixes && !options.fix && !options.fix_only && !options.diff) {
    return "--unsafe-fixes needs --fix, --fix-only or --diff";
  }
  return std::nullopt;
}

std::string no_such_rule(std::string_view id_or_name) {
  return "there is no rule '" + std::string(id_or_name) + "'" +
         did_you_mean(id_or_name, rule_words());
}

}  // namespace smurf::tools
