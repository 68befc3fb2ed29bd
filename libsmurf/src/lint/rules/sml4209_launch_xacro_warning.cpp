// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>

#include "lint/companions/launch.hpp"

namespace smurf::rules::sml4209_launch_xacro_warning_file {
namespace {

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  const Surroundings& all = companions.surroundings;
  if (all.noisy_calls.empty()) return;
  for (const LaunchFile& launch : all.launch_files) {
    for (const LaunchDescription& one : launch.descriptions) {
      const bool is_strict = one.form == LaunchDescription::Form::command && one.is_of_robot &&
                             !one.tolerates_errors && !launch.is_ros1;
      if (!is_strict) continue;
      for (const Span call : all.noisy_calls) {
        findings
            .report(call, "xacro warns about a function without `xacro.`, and the warning ends the "
                          "launch")
            .label(one.span, "this launch file runs xacro")
            .help("write `xacro.load_yaml(...)`, `xacro.abs_filename(...)` or `xacro.dotify(...)`");
      }
      return;
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::breaks, "ends the launch: the command wrote to its error output",
     "launch substitutions/command.py; xacro __init__.py (2.1.1, run)"},
};

}  // namespace

extern constinit const Rule sml4209_launch_xacro_warning{
    .id = "SML4209",
    .name = "launch-xacro-warning",
    .severity = Severity::error,
    .summary = "xacro warns about the robot, and the launch file ends at any warning.",
    .why =
        "`Command` fails when the program writes to its error output, unless it gets `on_stderr`.",
    .remedy = "Write `xacro.` before the function.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4209_launch_xacro_warning_file
