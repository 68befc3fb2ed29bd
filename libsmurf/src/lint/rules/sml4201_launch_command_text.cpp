// SPDX-License-Identifier: BSD-3-Clause
#include "lint/companions/launch.hpp"

namespace smurf::rules::sml4201_launch_command_text_file {
namespace {

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  if (!companions.surroundings.not_yaml) return;
  for_each_launch(companions, [&](const LaunchFile& launch) {
    if (launch.is_ros1) return;
    for (const LaunchDescription& one : launch.descriptions) {
      const bool is_command = one.form == LaunchDescription::Form::command;
      if (!is_command || one.is_wrapped || !one.is_of_robot) continue;
      findings
          .report(one.span, "the output of this command is read as YAML, which the text of the "
                            "robot is not")
          .label(*companions.surroundings.not_yaml, "YAML ends here")
          .help(launch.form == LaunchFile::Form::python
                    ? "write `ParameterValue(Command(...), value_type=str)`"
                : launch.form == LaunchFile::Form::xml ? "add `type=\"str\"`"
                                                       : "add `type: str`");
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::breaks,
     "ends the launch: it cannot parse the value of robot_description as YAML",
     "launch_ros evaluate_parameters.py, read; PyYAML 6, run"},
};

}  // namespace

extern constinit const Rule sml4201_launch_command_text{
    .id = "SML4201",
    .name = "launch-command-text",
    .severity = Severity::warning,
    .summary =
        "A launch file gives the text of the robot without ParameterValue, and it is no YAML.",
    .why =
        "launch_ros reads the output of `Command` as YAML: a colon before a blank, `#` after a blank or a tab, even in a comment, break it.",
    .remedy = "Wrap the command in `ParameterValue(..., value_type=str)`.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4201_launch_command_text_file
