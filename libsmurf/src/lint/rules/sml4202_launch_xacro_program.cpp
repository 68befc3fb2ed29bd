// SPDX-License-Identifier: BSD-3-Clause
#include <string_view>

#include "base/text/suggest.hpp"
#include "lint/companions/launch.hpp"

namespace smurf::rules::sml4202_launch_xacro_program_file {
namespace {

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_launch(companions, [&](const LaunchFile& launch) {
    for (const LaunchMistake& one : launch.mistakes) {
      if (one.kind != LaunchMistake::Kind::program) continue;
      Diagnostic& found = findings.report(one.span, one.message);
      found.help(one.help);
      if (one.replacement.empty()) continue;
      found.fixes.push_back({Applicability::unsafe, {{one.span, one.replacement}}});
    }
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
      constexpr std::string_view kPrograms[] = {"xacro"};
      const bool is_name = program.find('/') == std::string_view::npos;
      if (const auto near = near_name(program, kPrograms); near && is_name) {
        findings.report(one.program.span, "there is no program " + quoted(program))
            .help("did you mean " + quoted(*near) + "?");
        continue;
      }
      if (one.options.contains("-o") || one.options.contains("--output")) {
        findings
            .report(one.span, "xacro writes the robot into a file here, and launch gets no text")
            .help("delete `-o` and the name of the file");
      }
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
     "xacro setup.py and cli.py (2.1.1, run); launch substitutions/command.py and find_executable.py (1.0.7, 3.4.3, 3.7.1, run)"},
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
