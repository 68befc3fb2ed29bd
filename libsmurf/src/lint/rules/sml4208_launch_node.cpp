// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/suggest.hpp"
#include "base/text/words.hpp"
#include "lint/companions/launch.hpp"

namespace smurf::rules::sml4208_launch_node_file {
namespace {

constexpr Circumstance kTwice{"twice"};
constexpr Circumstance kPrefix{"prefix"};

void check_program(const LaunchNode& node, Findings& findings) {
  if (!node.package.is_known || !node.executable.is_known) return;
  for (const RosPackage& one : ros_packages()) {
    if (one.name != node.package.text || one.programs.empty()) continue;
    std::vector<std::string_view> names;
    for (std::size_t at = 0;;) {
      const std::string_view name = next_word(one.programs, at);
      if (name.empty()) break;
      if (name == node.executable.text) return;
      names.push_back(name);
    }
    const std::string_view program = node.executable.text;
    const bool is_script = program.ends_with(".py");
    const auto near = nearest(is_script ? program.substr(0, program.size() - 3) : program, names);
    const bool is_plain =
        is_script &&
        std::find(names.begin(), names.end(), program.substr(0, program.size() - 3)) != names.end();
    if (!near && !is_plain) return;
    const std::string right(is_plain ? program.substr(0, program.size() - 3) : *near);
    Diagnostic& found =
        findings.report(node.executable.span,
                        "the package " + quoted(one.name) + " has no program " + quoted(program));
    found.severity = Severity::error;
    found.help("did you mean " + quoted(right) + "?");
  }
}

void check_twice(const LaunchFile& launch, Findings& findings) {
  std::map<std::string, const LaunchNode*> first;  // by namespace
  for (const LaunchNode& node : launch.nodes) {
    if (!runs(node, "robot_state_publisher", "robot_state_publisher") || node.is_conditional)
      continue;
    if (node.has_namespace && !node.name_space.is_known) continue;
    const bool has_prefix =
        std::any_of(node.parameters.begin(), node.parameters.end(),
                    [](const auto& one) { return one.first.text == "frame_prefix"; });
    if (has_prefix) continue;
    const auto [other, is_new] = first.try_emplace(node.name_space.text, &node);
    if (is_new) continue;
    findings
        .report(node.executable.span, "a second robot_state_publisher publishes the same frames")
        .label(other->second->executable.span, "the first one starts here")
        .when(kTwice)
        .help("delete it, or give it a namespace and a `frame_prefix`");
  }
}

void check_prefix(const LaunchNode& node, Findings& findings) {
  if (!runs(node, "robot_state_publisher", "robot_state_publisher")) return;
  for (const auto& [name, value] : node.parameters) {
    const bool is_open = !value.is_known || value.text.empty() || value.text.ends_with("/") ||
                         value.text.ends_with("_");
    if (name.text != "frame_prefix" || is_open || !value.package.empty()) continue;
    Diagnostic& found =
        findings.report(value.span, "the prefix " + quoted(value.text) +
                                        " is put before the names of links as it is");
    found.severity = Severity::info;
    found.when(kPrefix);
    found.help("write " + quoted(value.text + "/") + ", with a slash at the end");
  }
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_launch(companions, [&](const LaunchFile& launch) {
    check_twice(launch, findings);
    for (const LaunchNode& node : launch.nodes) {
      if (!launch.is_ros1) check_program(node, findings);
      check_prefix(node, findings);
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::changes, "sends each transform twice", "robot_state_publisher.cpp",
     when(kTwice)},
    {&readers::ros, Effect::changes, "names the frames `PREFIXLINK`", "robot_state_publisher.cpp",
     when(kPrefix)},
    {&readers::ros, Effect::breaks, "ends the launch: the executable is not found",
     "launch_ros actions/node.py"},
};

}  // namespace

extern constinit const Rule sml4208_launch_node{
    .id = "SML4208",
    .name = "launch-node",
    .severity = Severity::warning,
    .summary =
        "A launch file starts a program that does not exist, or a robot_state_publisher twice.",
    .remedy = "Write the name of the program; start one robot_state_publisher in a namespace.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4208_launch_node_file
