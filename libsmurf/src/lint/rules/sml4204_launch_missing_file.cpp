// SPDX-License-Identifier: BSD-3-Clause
#include <set>
#include <string>

#include "lint/companions/launch.hpp"

namespace smurf::rules::sml4204_launch_missing_file_file {
namespace {

constexpr Circumstance kRobot{"robot"};

void report(const LaunchPath& one, bool is_robot, Findings& findings) {
  const std::string shown = one.text.package + one.text.text;
  Diagnostic& found = findings.report(
      one.text.span, quoted(shown) + " does not exist, neither in the sources nor installed");
  if (is_robot) {
    found.when(kRobot);
  } else if (one.text.by_default) {
    found.severity = Severity::warning;
  }
  if (one.similar.empty()) {
    found.help("correct the path, or add the file");
  } else {
    found.help("did you mean " + quoted(one.similar) + "?");
  }
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_launch(companions, [&](const LaunchFile& launch) {
    std::set<std::string> told;
    const auto look_at = [&](const LaunchPath& one, bool is_robot) {
      if (one.exists || !one.is_judged) return;
      if (told.insert(one.path).second) report(one, is_robot, findings);
    };
    for (const LaunchDescription& one : launch.descriptions) {
      // A path that is given as the text of the robot is never opened.
      if (one.file && one.form != LaunchDescription::Form::path) look_at(*one.file, true);
    }
    for (const LaunchPath& one : launch.paths) look_at(one, false);
  });
}

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::breaks, "ends the launch: there is no robot_description",
     "xacro 2.1.1, run", when(kRobot)},
    {&readers::ros, Effect::breaks, "ends the launch, or the node that gets the path",
     "launch launch_description_sources, rcl parse.c"},
};

}  // namespace

extern constinit const Rule sml4204_launch_missing_file{
    .id = "SML4204",
    .name = "launch-missing-file",
    .severity = Severity::error,
    .summary = "A launch file names a file of a package that does not exist.",
    .remedy =
        "Correct the path. It may be that of the source folder, or of what the package installs.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4204_launch_missing_file_file
