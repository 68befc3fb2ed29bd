// SPDX-License-Identifier: BSD-3-Clause
#include "lint/companions/launch.hpp"

namespace smurf::rules::sml4202_launch_xacro_program_file {
namespace {

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_launch(companions, [&](const LaunchFile& launch) {
    for (const LaunchDescription& one : launch.descriptions) {
      if (one.form != LaunchDescription::Form::command) continue;
      if (one.lacks_blank) {
        findings
            .report(one.span, "no blank stands between `xacro` and the path, so both are the name "
                              "of one program")
            .help("write a blank behind `xacro`");
      }
      if (!one.program.is_known) continue;
      const std::string_view program = one.program.text;
      if (program == "xacro.py" || program.ends_with("/xacro.py")) {
        findings.report(one.program.span, "there is no program `xacro.py` any more")
            .help("write `xacro`");
      } else if (!launch.is_ros1 && !one.tolerates_errors && one.options.contains("--inorder")) {
        findings.report(one.span, "xacro warns about `--inorder`, and a warning ends this launch")
            .help("delete `--inorder`");
      }
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::breaks, "ends the launch: there is no robot_description",
     "xacro setup.py and cli.py (2.1.1, run); launch substitutions/command.py"},
};

}  // namespace

extern constinit const Rule sml4202_launch_xacro_program{
    .id = "SML4202",
    .name = "launch-xacro-program",
    .severity = Severity::error,
    .summary = "A launch file calls xacro by a name or with an option that ends the launch.",
    .remedy = "Call `xacro`, with a blank behind it and without `--inorder`.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4202_launch_xacro_program_file
