// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-load-check/options.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "base/files/path.hpp"
#include "base/numbers/numbers.hpp"
#include "common/cli/shared_options.hpp"

namespace smurf::load_check {
namespace {

using tools::Option;
using tools::Setter;

Setter set_stages(std::set<Stage>& stages) {
  return [&stages](std::string_view list) -> std::optional<std::string> {
    stages.clear();
    std::vector<std::string> names;  // the help has them in lower case
    for (const std::string_view name : kStageNames) names.push_back(path::to_lower(name));
    for (const std::string_view item : tools::split_items(list)) {
      const std::string name = path::to_lower(item);
      const auto found = std::find(names.begin(), names.end(), name);
      if (found == names.end()) {
        return tools::none_of(item, std::vector<std::string_view>(names.begin(), names.end()));
      }
      stages.insert(static_cast<Stage>(found - names.begin()));
    }
    return std::nullopt;
  };
}

Setter set_seconds(std::optional<double>& seconds, double most) {
  return [&seconds, most](std::string_view text) -> std::optional<std::string> {
    const auto value = parse_number(text);
    if (!value || !(*value > 0) || !(*value <= most)) {
      return "'" + std::string(text) + "' is not a number of seconds above 0, at most " +
             format_number(most);
    }
    seconds = *value;
    return std::nullopt;
  };
}

Setter set_bounds(Bounds& bounds) {
  return [&bounds](std::string_view list) -> std::optional<std::string> {
    for (const std::string_view item : tools::split_items(list)) {
      if (auto wrong = bounds.set(item)) return wrong;
    }
    return std::nullopt;
  };
}

Setter set_time_limit(int& seconds) {
  return [&seconds](std::string_view text) -> std::optional<std::string> {
    std::optional<int> number;
    if (auto wrong = tools::set_number(number, 1)(text)) return wrong;
    seconds = *number;
    return std::nullopt;
  };
}

Setter set_memory_limit(std::uint64_t& bytes) {
  return [&bytes](std::string_view text) -> std::optional<std::string> {
    std::optional<int> number;
    if (auto wrong = tools::set_number(number, 1)(text)) return wrong;
    bytes = static_cast<std::uint64_t>(*number) << 20U;
    return std::nullopt;
  };
}

std::string_view bounds_help() {
  static const std::string help = [] {
    std::string text = "Replace bounds, separated by commas. The defaults:";
    for (const BoundInfo& info : kBounds) {
      text.append(" ").append(info.name).append("=").append(format_number(info.limit));
      if (!info.unit.empty()) text.append(" ").append(info.unit);
      text.append(&info == &kBounds.back() ? "." : ",");
    }
    return text;
  }();
  return help;
}

std::string format_hint(std::string_view value) {
  if (tools::find_report_format(value) == nullptr) return {};
  return "; --report " + std::string(value) + " writes the findings in this format";
}

std::vector<Option> check_options(Options& options) {
  constexpr double kLongest = 3600;
  constexpr double kLongestStep = 1;
  return {
      {.group = "Check",
       .name = "stages",
       .metavar = "LIST",
       .help =
           "Run only these stages: pose0, still, hang, drop, anchor. The stage build is always run.",
       .set = set_stages(options.check.stages)},
      {.group = "Check",
       .name = "pose",
       .metavar = "NAME",
       .help =
           "Start models in their joint pose NAME. Joints that it does not name start at zero, or "
           "at the nearest position within their limits.",
       .set = tools::set_text(options.check.pose)},
      {.group = "Check",
       .name = "time",
       .metavar = "S",
       .help = "Simulate S seconds in each stage; the default is 0.5, and 0.25 for HANG. In longer "
               "runs, joint stops may add energy even to a sound robot that has no damping.",
       .set = set_seconds(options.check.time, kLongest)},
      {.group = "Check",
       .name = "step",
       .metavar = "S",
       .help = "Simulate in steps of S seconds. The default is 0.001, for which the bounds are "
               "calibrated; for ANCHOR, the step of the scene, or 0.01.",
       .set = set_seconds(options.check.step, kLongestStep)},
      {.group = "Check",
       .name = "bounds",
       .metavar = "LIST",
       .help = bounds_help(),
       .set = set_bounds(options.check.bounds)},
      {.group = "Check",
       .name = "time-limit",
       .metavar = "S",
       .help = "Give a model, or a scene and all of its models, at most S seconds of processor "
               "time; the default is 10.",
       .set = set_time_limit(options.limits.seconds)},
      {.group = "Check",
       .name = "memory-limit",
       .metavar = "MB",
       .help =
           "Give one check at most MB megabytes of memory in addition to its files; the default "
           "is 160.",
       .set = set_memory_limit(options.limits.memory_bytes)},
  };
}

std::vector<Option> output_options(Options& options) {
  return {
      {.group = "Output",
       .name = "format",
       .metavar = "FORMAT",
       .help = "Choose the format: full (the default), with tables and source lines, or json, for "
               "programs. --report writes the findings alone in other formats.",
       .values = {"full", "json"},
       .hint = format_hint,
       .set = tools::set_text(options.format)},
      tools::output_option(options.output, "Write the report to FILE."),
      tools::report_option("report", options.reports),
      {.group = "Output",
       .name = "all",
       .help = "Print the table of stages for models that pass as well.",
       .set = tools::set_flag(options.all)},
      {.group = "Output",
       .name = "trace",
       .metavar = "FILE",
       .help =
           "Write the pose of every link after every step, as CSV; at most 64 MB. The checks are "
           "run one after the other.",
       .set = tools::set_text(options.trace)},
  };
}

}  // namespace

tools::Command command_of(Options& options) {
  tools::Command command;
  command.name = "smurf-load-check";
  command.summary =
      "Builds SMURF models, URDFs and scenes in the physics engine ODE and tests whether they "
      "stand, hang and drop without breaking.";
  command.operands = "[PATH]... [NAME:=VALUE]...";
  command.details =
      "PATH is a .smurf, .urdf, .xacro, .smurfs, .smurfa or .svg file, an archive (.zsmurf, "
      ".zsmurfs, .zsmurfa), or a folder to search; without one, the current folder is searched. "
      "NAME:=VALUE is an argument of the .xacro files that are named; folders are not searched for "
      "them. Every model "
      "is checked on its own: BUILD makes bodies, joints and shapes; POSE0 reports overlapping "
      "shapes; STILL reports motion without gravity; HANG fixes the root link and lets the other "
      "links hang; DROP drops the model from a height of 1 mm. In a scene, ANCHOR reports anchors "
      "that give way. Parts that ODE refuses to build are replaced, so that the rest is checked; "
      "after any other failed stage the check ends. When ODE's solver gives up, the stage has no "
      "verdict and does not pass. Meshes that do not move keep their triangles. Moving meshes "
      "become their bounding boxes, which touch only the ground and the surroundings, because ODE "
      "may crash where two triangle meshes cross.";
  for (auto& group : {check_options(options), output_options(options)}) {
    command.options.insert(command.options.end(), group.begin(), group.end());
  }
  command.options.push_back(tools::fail_on_option(options.threshold));
  command.options.push_back(tools::stdin_filename_option(options.input.stdin_filename));
  command.options.push_back(tools::package_option(options.input.packages));
  command.options.push_back(tools::xacro_env_option(options.input.xacro.environment));
  command.options.push_back(tools::allow_outside_option(options.input.allow_outside));
  command.options.push_back(tools::limit_option(options.input.limits));
  command.options.push_back(tools::max_seconds_option(options.input.max_seconds));
  command.options.push_back(tools::jobs_option(options.jobs));
  command.options.push_back(tools::color_option(options.color));
  command.options.push_back(
      tools::quiet_option(options.quiet, "Print nothing about models that pass, and no summary."));
  command.set_operand = [&options](std::string_view value) -> std::optional<std::string> {
    const bool is_argument = tools::take_xacro_argument(value, options.input.xacro);
    if (!is_argument) options.input.paths.emplace_back(value);
    return std::nullopt;
  };
  command.examples = {{"smurf-load-check robot.smurf", "Check one robot:"},
                      {"smurf-load-check -j 4 --format json -o report.json models/",
                       "Check all robots of a folder:"}};
  return command;
}

}  // namespace smurf::load_check
