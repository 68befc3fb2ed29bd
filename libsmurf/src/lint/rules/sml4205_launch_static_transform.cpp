// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>
#include <string_view>

#include "base/text/suggest.hpp"
#include "lint/companions/frames.hpp"
#include "lint/companions/launch.hpp"

namespace smurf::rules::sml4205_launch_static_transform_file {
namespace {

constexpr Circumstance kWords{"words"};
constexpr Circumstance kTwoParents{"two parents"};

void check_words(const LaunchNode& node, Findings& findings) {
  const auto has = [&](std::string_view option) {
    return std::any_of(node.arguments.begin(), node.arguments.end(),
                       [&](const LaunchText& one) { return one.text == option; });
  };
  const bool has_parent = has("--frame-id"), has_child = has("--child-frame-id");
  if (has_parent == has_child) return;
  Diagnostic& found = findings.report(node.arguments.front().span,
                                      std::string("`static_transform_publisher` has no ") +
                                          (has_parent ? "`--child-frame-id`" : "`--frame-id`"));
  found.severity = Severity::error;
  found.when(kWords);
  found.help("give both frames");
}

void check_node(const LinkedModel& model, const LaunchNode& node, const Surroundings& all,
                Findings& findings) {
  const auto transform = static_transform_of(node);
  if (!transform || node.arguments.empty()) return;
  check_words(node, findings);
  if (!model.robot || all.has_frame_prefix || node.is_conditional) return;
  const auto known = model.link_names.names();
  if (transform->child != nullptr && transform->parent != nullptr) {
    const auto link = model.link_index(transform->child->text);
    const bool has_parent = link && model.tree.parent_joint[to_size(*link)];
    if (has_parent && model.link_index(transform->parent->text)) {
      const auto joint = *model.tree.parent_joint[to_size(*link)];
      findings
          .report(transform->child->span, "the robot places " + quoted(transform->child->text) +
                                              " already, so the frame has two parents")
          .label(model.joint(joint).name.span, "by this joint")
          .when(kTwoParents)
          .help("delete the static transform, or give it a frame that is no link");
    }
  }
  for (const LaunchText* one : {transform->parent, transform->child}) {
    if (one == nullptr || model.link_names.contains(one->text) || is_world_frame(one->text))
      continue;
    const auto near = near_name(one->text, known);
    if (!near || is_published_elsewhere(all, one->text)) continue;
    if (one == transform->child) continue;  // a frame of its own
    findings
        .report(one->span, "the static transform names the frame " + quoted(one->text) +
                               ", which is no link of the robot")
        .when(kMisspeltFrame)
        .help("did you mean " + quoted(*near) + "?");
  }
}

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  const Surroundings& all = companions.surroundings;
  for_each_launch(companions, [&](const LaunchFile& launch) {
    const bool is_of_robot = std::any_of(launch.descriptions.begin(), launch.descriptions.end(),
                                         [](const auto& one) { return one.is_of_robot; });
    if (!is_of_robot || launch.is_ros1) return;
    for (const LaunchNode& node : launch.nodes) check_node(model, node, all, findings);
  });
}

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::breaks, "prints how to use it, and ends",
     "geometry2 static_transform_broadcaster_program.cpp", when(kWords)},
    {&readers::ros, Effect::changes, "lets the frame jump between two places",
     "geometry2 buffer_core.cpp; robot_state_publisher.cpp", when(kTwoParents)},
    {&readers::ros, Effect::loses, "publishes a frame that is not connected with the robot",
     "geometry2 buffer_core.cpp", when(kMisspeltFrame)},
};

}  // namespace

extern constinit const Rule sml4205_launch_static_transform{
    .id = "SML4205",
    .name = "launch-static-transform",
    .severity = Severity::warning,
    .summary = "A static transform of a launch file does not fit the frames of the robot.",
    .remedy = "Name a link as the parent, and a frame that the robot does not have as the child.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4205_launch_static_transform_file
