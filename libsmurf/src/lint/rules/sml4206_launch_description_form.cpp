// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>
#include <string_view>

#include "base/text/suggest.hpp"
#include "lint/companions/launch.hpp"

namespace smurf::rules::sml4206_launch_description_form_file {
namespace {

constexpr Circumstance kMacros{"macros"};
constexpr Circumstance kPath{"path"};
constexpr Circumstance kName{"name"};

bool is_xacro(const LaunchDescription& one) {
  return one.file && (one.file->text.text.ends_with(".xacro"));
}

void check_form(const LaunchFile& launch, const LaunchDescription& one, Findings& findings) {
  if (one.form == LaunchDescription::Form::content && is_xacro(one) && one.file->text.is_known) {
    Diagnostic& found = findings.report(
        one.span, "the robot is given as it is written, with its macros; xacro does "
                  "not expand it");
    if (one.file->text.by_default) found.severity = Severity::warning;
    found.when(kMacros).help("write " + std::string(xacro_call(launch)));
  } else if (one.form == LaunchDescription::Form::path) {
    Diagnostic& found =
        findings.report(one.span, "`robot_description` is the path of the file, not its text");
    if (one.file->text.by_default) found.severity = Severity::warning;
    found.when(kPath).help("give the text of the file: " + std::string(xacro_call(launch)));
  }
}

void check_node(const LaunchNode& node, Findings& findings) {
  if (!runs(node, "robot_state_publisher", "robot_state_publisher")) return;
  constexpr std::string_view kNames[] = {"robot_description"};
  const bool has_own = std::any_of(node.parameters.begin(), node.parameters.end(),
                                   [&](const auto& one) { return one.first.text == kNames[0]; });
  if (has_own) return;
  for (const auto& [name, value] : node.parameters) {
    if (!name.is_known || !only_nearest(name.text, kNames)) continue;
    findings.report(name.span, "robot_state_publisher has no parameter " + quoted(name.text))
        .when(kName)
        .help("did you mean `robot_description`?");
  }
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_launch(companions, [&](const LaunchFile& launch) {
    for (const LaunchDescription& one : launch.descriptions) check_form(launch, one, findings);
    for (const LaunchNode& node : launch.nodes) check_node(node, findings);
  });
}

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::breaks, "gives robot_state_publisher macros instead of links: it ends",
     "robot_state_publisher.cpp, branches humble and rolling", when(kMacros)},
    {&readers::ros, Effect::breaks, "cannot read the robot: robot_state_publisher ends",
     "robot_state_publisher.cpp, branches humble and rolling", when(kPath)},
    {&readers::ros, Effect::breaks, "ends robot_state_publisher: robot_description is empty",
     "robot_state_publisher.cpp, branches humble and rolling", when(kName)},
};

}  // namespace

extern constinit const Rule sml4206_launch_description_form{
    .id = "SML4206",
    .name = "launch-description-form",
    .severity = Severity::error,
    .summary =
        "A launch file gives something else than the text of the robot as robot_description.",
    .remedy = "Give the output of xacro, or the text of a URDF.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4206_launch_description_form_file
