// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/suggest.hpp"
#include "lint/companions/launch.hpp"

namespace smurf::rules::sml4203_launch_xacro_argument_file {
namespace {

constexpr Circumstance kMissing{"missing"};

void check_one(const LaunchDescription& one, const std::vector<XacroArgument>& known,
               Findings& findings) {
  std::vector<std::string_view> names;
  for (const XacroArgument& argument : known) names.push_back(argument.name);
  for (const LaunchDescription::Argument& argument : one.arguments) {
    if (std::find(names.begin(), names.end(), argument.name) != names.end()) continue;
    Diagnostic& found = findings.report(
        argument.span, "the xacro has no argument " + quoted(argument.name) + ", and ignores it");
    if (const auto near = only_nearest(argument.name, names)) {
      found.help("did you mean " + quoted(*near) + "?");
    } else {
      found.help("delete it, or add `<xacro:arg name=\"" + argument.name + "\" default=\"...\"/>`");
    }
  }
  if (one.has_unknown_words) return;
  std::set<std::string_view> told;
  for (const XacroArgument& argument : known) {
    const bool is_given =
        argument.has_default ||
        std::any_of(one.arguments.begin(), one.arguments.end(),
                    [&](const auto& given) { return given.name == argument.name; });
    const bool is_declared_again =
        std::any_of(known.begin(), known.end(), [&](const XacroArgument& other) {
          return other.name == argument.name && other.has_default;
        });
    if (is_given || is_declared_again || !told.insert(argument.name).second) continue;
    Diagnostic& found =
        findings.report(one.span, "the xacro needs the argument " + quoted(argument.name) +
                                      ", which has no default");
    found.severity = Severity::error;
    found.when(kMissing);
    found.help(one.form == LaunchDescription::Form::expanded
                   ? "add " + quoted(argument.name) + " to `mappings`"
                   : "add `" + argument.name + ":=...` to the command");
  }
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  const Surroundings& all = companions.surroundings;
  if (!all.is_xacro || !all.has_all_arguments) return;
  if (!all.is_expanded && all.arguments.empty()) return;
  for_each_launch(companions, [&](const LaunchFile& launch) {
    for (const LaunchDescription& one : launch.descriptions) {
      const bool is_xacro = one.form == LaunchDescription::Form::command ||
                            one.form == LaunchDescription::Form::expanded;
      if (is_xacro && one.is_of_robot) check_one(one, all.arguments, findings);
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::breaks, "ends the launch: xacro misses the argument",
     "xacro 2.1.1, run", when(kMissing)},
    {&readers::ros, Effect::loses, "makes the robot with the default instead", "xacro 2.1.1, run"},
};

}  // namespace

extern constinit const Rule sml4203_launch_xacro_argument{
    .id = "SML4203",
    .name = "launch-xacro-argument",
    .severity = Severity::warning,
    .summary =
        "A launch file gives xacro an argument that it does not have, or not one that it needs.",
    .why = "xacro ignores an unknown argument without a message.",
    .remedy = "Write the arguments that the xacro declares.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4203_launch_xacro_argument_file
