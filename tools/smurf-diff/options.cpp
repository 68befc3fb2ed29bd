// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-diff/options.hpp"

#include <algorithm>
#include <utility>

#include "base/numbers.hpp"
#include "common/shared_options.hpp"

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
       .help = "text (the default) or json.",
       .values = {"text", "json"},
       .set = choose<DiffFormat>(options.format,
                                 {{"text", DiffFormat::text}, {"json", DiffFormat::json}})},
      {.group = "Comparison",
       .name = "git",
       .help =
           "Run as the diff driver of git: take the operands that git passes, and exit with 0 when "
           "the files differ.",
       .set = set_flag(options.for_git)}};
}

}  // namespace

Command make_command(Options& options) {
  Command command;
  command.name = "smurf-diff";
  command.summary = "Shows what changed for the robot between two versions of a model or scene.";
  command.operands = "OLD NEW";
  command.details =
      "OLD and NEW are two models (.smurf, .urdf), two annotation files (.yml) or two scenes "
      "(.smurfs, .smurfa, .svg), or archives of them; '-' is standard input. Things are compared "
      "by their names: links, joints, visuals, collisions, inertias, materials, motors, sensors "
      "and all other entries of annotations, entities of scenes. Renamed things are recognised by "
      "their contents. Formatting, order, comments and values that equal the default are ignored; "
      "inertias are compared in the frame of the link, rotations by their angle, meshes by the "
      "content of their files. A model and a URDF are compared as robots, without annotations. The "
      "exit code is 0 when nothing differs, 1 when something does, 2 when a file cannot be read.";
  command.options = own_options(options);
  for (Option& option : std::vector<Option>{
           output_option(options.output,
                         "Write the differences to FILE instead of standard output."),
           stdin_filename_option(options.stdin_filename), package_option(options.packages),
           allow_outside_option(options.allow_outside), limit_option(options.limits),
           color_option(options.color),
           quiet_option(options.quiet, "Print no differences; the exit code tells.")}) {
    command.options.push_back(std::move(option));
  }
  command.set_operand = append_to(options.operands);
  command.examples = {
      {"smurf-diff old/robot.urdf new/robot.urdf", "Compare two versions of a robot:"},
      {"git config diff.smurf.command \"smurf-diff --git\"",
       "Show robots in git diff, with the line \"*.urdf diff=smurf\" in .gitattributes:"},
      {"smurf-diff --format json -o changes.json old/cell.smurfs new/cell.smurfs",
       "Compare scenes, and write JSON for a program:"},
      {"smurf-diff --tolerance 1e-4 robot.urdf exported.urdf", "Ignore rounding errors:"}};
  return command;
}

std::string problem_of(const Options& options) {
  const std::size_t count = options.operands.size();
  if (options.for_git) {
    // One for a file that is not merged, two more for one that was renamed.
    const bool is_from_git = count == 1 || count == 7 || count == 9;
    return is_from_git ? ""
                       : "--git takes the 7 operands that git gives, not " + std::to_string(count);
  }
  if (count != 2) {
    return "two inputs are compared, not " + std::to_string(count) + "; see --help";
  }
  if (std::ranges::count(options.operands, "-") > 1)
    return "standard input can be one of them only";
  return {};
}

}  // namespace smurf::tools
