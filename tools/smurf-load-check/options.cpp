// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-load-check/options.hpp"

#include <algorithm>

#include "base/numbers.hpp"
#include "common/shared_options.hpp"

namespace smurf::load_check {
namespace {

using tools::Option;
using tools::Setter;

Setter set_stages(std::set<Stage>& stages) {
  return [&stages](std::string_view list) -> std::optional<std::string> {
    stages.clear();
    for (const std::string_view item : tools::split_items(list)) {
      std::string name(item);
      std::transform(name.begin(), name.end(), name.begin(),
                     [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
      const auto* found = std::find(kStageNames.begin(), kStageNames.end(), name);
      if (found == kStageNames.end()) return tools::none_of(name, kStageNames);
      stages.insert(static_cast<Stage>(found - kStageNames.begin()));
    }
    return std::nullopt;
  };
}

Setter set_seconds(std::optional<double>& seconds, double most) {
  return [&seconds, most](std::string_view text) -> std::optional<std::string> {
    const auto value = parse_number(text);
    if (!value || !(*value > 0) || !(*value <= most)) {
      return "'" + std::string(text) + "' is no number of seconds above 0, at most " +
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
    std::string text = "Other bounds than the usual ones, separated by commas:";
    for (const BoundInfo& info : kBounds) {
      text.append(" ").append(info.name).append("=").append(format_number(info.limit));
      if (!info.unit.empty()) text.append(" ").append(info.unit);
      text.append(&info == &kBounds.back() ? "." : ",");
    }
    return text;
  }();
  return help;
}

std::vector<Option> check_options(Options& options) {
  constexpr double kLongest = 3600;
  constexpr double kLongestStep = 1;
  return {
      {.group = "Check",
       .name = "stages",
       .metavar = "LIST",
       .help = "Only these stages: pose0, still, hang, drop, anchor. BUILD is always run.",
       .set = set_stages(options.check.stages)},
      {.group = "Check",
       .name = "pose",
       .metavar = "NAME",
       .help = "Start models in this pose of theirs. Other joints start at zero, or where that is "
               "outside their limits at the nearest position within.",
       .set = tools::set_text(options.check.pose)},
      {.group = "Check",
       .name = "time",
       .metavar = "S",
       .help = "Seconds that each stage simulates: 0.5 usually, 0.25 for HANG. After more, the "
               "stops of undamped limbs may pump energy into sound robots.",
       .set = set_seconds(options.check.time, kLongest)},
      {.group = "Check",
       .name = "step",
       .metavar = "S",
       .help = "Seconds of one step: 0.001 usually, which the bounds are for; for ANCHOR the "
               "scene's, else 0.01.",
       .set = set_seconds(options.check.step, kLongestStep)},
      {.group = "Check",
       .name = "bounds",
       .metavar = "LIST",
       .help = bounds_help(),
       .set = set_bounds(options.check.bounds)},
      {.group = "Check",
       .name = "time-limit",
       .metavar = "S",
       .help = "Seconds of processor time for a model, or for a scene and all of its models; 10 "
               "usually.",
       .set = set_time_limit(options.limits.seconds)},
      {.group = "Check",
       .name = "memory-limit",
       .metavar = "MB",
       .help = "Megabytes that one check may take beside the files; 160 usually.",
       .set = set_memory_limit(options.limits.memory_bytes)},
  };
}

std::vector<Option> output_options(Options& options) {
  return {
      {.group = "Output",
       .name = "format",
       .metavar = "FORMAT",
       .help = "full: tables and source lines; json: for programs.",
       .values = {"full", "json"},
       .set = tools::set_text(options.format)},
      tools::output_option(options.output, "Write the report to FILE."),
      tools::report_option("report", options.reports),
      {.group = "Output",
       .name = "trace",
       .metavar = "FILE",
       .help =
           "Write the pose of every link after every step, as CSV; at most 64 MB. The checks are run "
           "one after the other.",
       .set = tools::set_text(options.trace)},
      {.group = "Output",
       .name = "plot",
       .metavar = "FILE",
       .help = "Draw energy and joint gap over time, as SVG. Takes one model or scene.",
       .set = tools::set_text(options.plot)},
  };
}

}  // namespace

tools::Command command_of(Options& options) {
  tools::Command command;
  command.name = "smurf-load-check";
  command.summary =
      "Builds SMURF models, URDFs and scenes in the physics engine ODE and looks whether they "
      "stand, hang and drop.";
  command.operands = "[PATH]...";
  command.details =
      "PATH is a .smurf, .urdf, .smurfs, .smurfa or .svg file, an archive (.zsmurf, .zsmurfs, .zsmurfa), or a folder that is searched for "
      "models and scenes; '.' unless given. Every model is checked on its own: BUILD makes bodies, joints and shapes; "
      "POSE0 looks for shapes inside each other; STILL, without gravity, sees whether anything "
      "moves; HANG holds the root link; DROP lets the model fall by a millimetre. In a scene, "
      "ANCHOR sees whether anchors hold. What BUILD refuses has a stand-in, so that the rest is "
      "checked; another stage that fails is the last one. Where ODE's solver gives up, there is no "
      "verdict, which is no pass. Meshes that stand still "
      "are triangles; those that move are boxes around them, which touch the ground and the "
      "surroundings only, as ODE may crash where two meshes of triangles cross.";
  for (auto& group : {check_options(options), output_options(options)}) {
    command.options.insert(command.options.end(), group.begin(), group.end());
  }
  command.options.push_back(tools::fail_on_option(options.threshold));
  command.options.push_back(tools::stdin_filename_option(options.input.stdin_filename));
  command.options.push_back(tools::package_option(options.input.packages));
  command.options.push_back(tools::allow_outside_option(options.input.allow_outside));
  command.options.push_back(tools::limit_option(options.input.limits));
  command.options.push_back(tools::jobs_option(options.jobs));
  command.options.push_back(tools::color_option(options.color));
  command.options.push_back(
      tools::quiet_option(options.quiet, "No tables of what passes, and no summary."));
  command.set_operand = tools::append_to(options.input.paths);
  command.examples = {{"smurf-load-check robot.smurf", "check one robot"},
                      {"smurf-load-check -j 4 --format json -o report.json models/",
                       "check all robots of a folder"},
                      {"smurf-load-check robot.urdf --stages hang --time 1 --plot hang.svg",
                       "see how energy and joints behave"}};
  return command;
}

}  // namespace smurf::load_check
