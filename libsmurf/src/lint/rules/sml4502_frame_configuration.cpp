// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <string_view>

#include "lint/companions/controllers.hpp"
#include "lint/companions/launch.hpp"

namespace smurf::rules::sml4502_frame_configuration_file {
namespace {

std::string_view text_at(yaml::View mapping, std::string_view key, std::string_view fallback) {
  const yaml::View value = mapping.find(key);
  return value && value.is_scalar() ? value.text() : fallback;
}

/// robot_localization: the frames of one filter.
void check_filter(yaml::View node, Findings& findings) {
  const std::string_view map = text_at(node, "map_frame", "map");
  const std::string_view odom = text_at(node, "odom_frame", "odom");
  const std::string_view base = text_at(node, "base_link_frame", "base_link");
  const std::string_view world = text_at(node, "world_frame", odom);
  if (is_placeholder(map) || is_placeholder(odom) || is_placeholder(base) || is_placeholder(world))
    return;
  const yaml::View written = node.find("world_frame");
  if (written && world != map && world != odom) {
    findings
        .report(written.span(),
                "`world_frame` is " + quoted(world) + ", but must be `map_frame` or `odom_frame`")
        .help("write " + quoted(map) + " or " + quoted(odom));
  }
  const yaml::View odom_value = node.find("odom_frame");
  if (odom_value && odom == base) {
    findings
        .report(odom_value.span(), "`odom_frame` and `base_link_frame` are both " + quoted(base))
        .help("write `odom`");
  }
  const yaml::View map_value = node.find("map_frame");
  if (map_value && (map == odom || map == base)) {
    findings
        .report(map_value.span(), "`map_frame` is " + quoted(map) + ", which another frame is, too")
        .help("write `map`");
  }
}

// The recursion is as deep as the file, whose depth is limited.
void visit(yaml::View mapping, Findings& findings) {
  if (mapping.find("base_link_frame") ||
      (mapping.find("world_frame") && mapping.find("odom_frame"))) {
    check_filter(mapping, findings);
  }
  for (const yaml::View member : mapping) {
    if (member.is_mapping()) visit(member, findings);
  }
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for (const FrameFile& one : companions.surroundings.frame_files) {
    if (one.form != FrameFile::Form::parameters || !one.document) continue;
    const yaml::View root = one.document->view();
    if (root && root.is_mapping()) visit(root, findings);
  }
}

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::breaks, "ends robot_localization: invalid frame configuration",
     "robot_localization ros_filter.cpp, branch ros2"},
};

}  // namespace

extern constinit const Rule sml4502_frame_configuration{
    .id = "SML4502",
    .name = "frame-configuration",
    .severity = Severity::error,
    .summary = "The frames of a filter of robot_localization contradict each other.",
    .remedy = "Let map, odom and base be three frames, and `world_frame` one of the first two.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4502_frame_configuration_file
