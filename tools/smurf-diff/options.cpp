// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-diff/options.hpp"

#include <algorithm>
#include <utility>

#include "base/numbers/numbers.hpp"
#include "common/cli/shared_options.hpp"

namespace smurf::tools {
namespace {

Setter set_tolerance(double& tolerance) {
  return [&tolerance](std::string_view value) -> std::optional<std::string> {
    const std::optional<double> number = parse_number(value);
    if (!number || *number < 0) return "'" + std::string(value) + "' is not a number of at least 0";
    tolerance = *number;
    return std::nullopt;
  };
}

std::vector<Option> own_options(Options& options) {
  return {
      {.group = "Comparison",
       .name = "tolerance",
       .metavar = "T",
       .help =
           "Treat values that differ by at most T as equal. T is absolute for metres, radians and "
           "numbers without a unit (axes, colours), and relative to the larger value for masses, "
           "inertias, efforts and all others. The default is 1e-9.",
       .set = set_tolerance(options.tolerance)},
      {.group = "Output",
       .name = "format",
       .metavar = "FORMAT",
       .help = "Choose the format: text (the default), json, or html, a page for a browser that "
               "lists the differences and overlays both versions in 3D.",
       .values = {"text", "json", "html"},
       .set = choose<DiffFormat>(
           options.format,
           {{"text", DiffFormat::text}, {"json", DiffFormat::json}, {"html", DiffFormat::html}})},
      {.group = "Comparison",
       .name = "git",
       .help =
           "Run as the diff driver of git: read all following arguments as operands from git, and "
           "exit with 0 when the files differ.",
       .set = set_flag(options.for_git)}};
}

/// "100644", or "." for a file that is missing.
bool is_mode(std::string_view text) {
  return text == "." || (text.size() == 6 && text.find_first_not_of("01234567") == text.npos);
}

/// One operand for an unmerged file, two more for a renamed file.
bool is_from_git(const std::vector<std::string>& operands) {
  if (operands.size() == 1) return true;
  return (operands.size() == 7 || operands.size() == 9) && is_mode(operands[3]) &&
         is_mode(operands[6]);
}

/// `name:=value` is an argument of the xacro file before it.
Setter take_operand(Options& options) {
  return [&options](std::string_view value) -> std::optional<std::string> {
    XacroSettings xacro;
    if (options.for_git || !take_xacro_argument(value, xacro)) {
      options.operands.emplace_back(value);
      options.xacro.emplace_back();
      return std::nullopt;
    }
    if (options.operands.empty()) {
      return "'" + std::string(value) + "' is an argument of a xacro file; write it after the file";
    }
    options.xacro.back().arguments.merge(xacro.arguments);
    return std::nullopt;
  };
}

}  // namespace

void drop_separator(std::vector<std::string>& operands) {
  if (operands.empty() || operands.front() != "--") return;
  // Git passes an odd number of arguments, so a first "--" may be a file of that name.
  if (operands.size() % 2 == 0) operands.erase(operands.begin());
}

std::string shown_operand(const Options& options, std::size_t index) {
  std::string text = options.operands[index];
  if (index >= options.xacro.size()) return text;
  for (const auto& [name, value] : options.xacro[index].arguments) {
    text.append(" ").append(name).append(":=").append(value);
  }
  return text;
}

Command make_command(Options& options) {
  Command command;
  command.name = "smurf-diff";
  command.summary = "Shows what changed for the robot between two versions of a model or scene.";
  command.operands = "OLD [NAME:=VALUE]... NEW [NAME:=VALUE]...";
  command.details =
      "OLD and NEW are two models (.smurf, .urdf, .xacro), two annotation files (.yml) or two "
      "scenes (.smurfs, .smurfa, .svg), archives of them, or folders with one of them; '-' is "
      "standard input. Things are compared by their names: links, joints, visuals, collisions, "
      "inertias, materials, motors, sensors and all other entries of annotations, entities of "
      "scenes. Renamed things are recognised by their contents. Formatting, order, comments and "
      "values that equal the default are ignored; inertias are compared in the frame of the link, "
      "rotations by their angle, meshes by the content of their files. A model and a URDF are "
      "compared as robots, without annotations. A .xacro file is expanded with the arguments "
      "NAME:=VALUE that follow it; OLD and NEW may be the same file with other arguments. The "
      "exit code is 0 when nothing differs, 1 when something does, 2 when a file cannot be read.";
  command.options = own_options(options);
  for (Option& option : std::vector<Option>{
           output_option(options.output,
                         "Write the differences to FILE instead of standard output."),
           open_option(options.opens), stdin_filename_option(options.stdin_filename),
           package_option(options.packages), xacro_env_option(options.environment),
           allow_outside_option(options.allow_outside), limit_option(options.limits),
           max_seconds_option(options.max_seconds), color_option(options.color),
           quiet_option(options.quiet, "Print no differences; exit with 1 if there are any.")}) {
    command.options.push_back(std::move(option));
  }
  command.set_operand = take_operand(options);
  command.exit_with_1 = "the robots differ";
  command.examples = {
      {"smurf-diff old/robot.urdf new/robot.urdf", "Compare two versions of a robot:"},
      {"git config diff.smurf.command \"smurf-diff --git\"",
       "Show robots in git diff, with the line \"*.urdf diff=smurf\" in .gitattributes:"},
      {"smurf-diff --format json -o changes.json old/cell.smurfs new/cell.smurfs",
       "Compare scenes, and write JSON for a program:"},
      {"smurf-diff --open old/robot.urdf new/robot.urdf",
       "See both versions over each other in a browser:"},
      {"smurf-diff arm.urdf.xacro side:=left arm.urdf.xacro side:=right",
       "Compare a xacro file with itself, with other arguments:"},
      {"smurf-diff --tolerance 1e-4 robot.urdf exported.urdf", "Ignore rounding errors:"}};
  return command;
}

std::string problem_of(const Options& options) {
  const std::size_t count = options.operands.size();
  if (options.for_git) {
    return is_from_git(options.operands)
               ? ""
               : "--git needs the 7 operands that git passes, and no options after it";
  }
  if (options.opens && options.quiet) return "--open shows what --quiet leaves out";
  if (count != 2) {
    return "two inputs are compared, not " + std::to_string(count) + "; see --help";
  }
  if (std::ranges::count(options.operands, "-") > 1)
    return "only one of them can be standard input";
  return {};
}

}  // namespace smurf::tools
