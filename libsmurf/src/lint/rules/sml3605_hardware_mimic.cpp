// SPDX-License-Identifier: BSD-3-Clause
#include "base/files/path.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3605_hardware_mimic_file {
namespace {

void check_joint(const Hardware& hardware, const HardwarePart& part, const urdf::Joint& joint,
                 Findings& findings) {
  const std::string mimic = path::to_lower(attribute_text(part.element, "mimic"));
  const std::string title = title_of(part, hardware);
  const bool follows = joint.mimic && joint.mimic->joint;
  if (!follows) {
    if (mimic != "true") return;
    findings
        .report(place_of(part.element, "mimic"),
                title + " has mimic=\"true\", but the joint mimics no other")
        .label(joint.name.span, "the joint is defined here")
        .help("write `<mimic>` into the joint, or delete the attribute");
    return;
  }
  if (mimic == "false") return;
  const std::string leader = quoted(*joint.mimic->joint);
  if (part.has_command()) {
    findings
        .report(place_of(part.element, "name"),
                title + " has a command interface, but the joint mimics " + leader)
        .label(joint.mimic->joint.span, "it mimics another joint here")
        .help("delete its command interfaces, or write mimic=\"false\"");
  } else if (hardware.find_joint(*joint.mimic->joint) == nullptr) {
    findings
        .report(place_of(part.element, "name"),
                title + " mimics " + leader + ", which this ros2_control does not have")
        .label(joint.mimic->joint.span, "it mimics another joint here")
        .help("add that joint to the same `ros2_control`, or write mimic=\"false\"");
  }
}

void check(const LinkedModel& model, const Companions&, Findings& findings) {
  for (const Hardware& hardware : hardware_of(model)) {
    for (const HardwarePart& part : hardware.parts) {
      const urdf::Joint* joint = part.is_joint() ? model.find_joint(part.name) : nullptr;
      if (joint != nullptr) check_joint(hardware, part, *joint, findings);
    }
  }
}

constexpr std::string_view kUnread = "ros2_control does not look at `<mimic>` of the robot";

constexpr Fact kFacts[] = {no_hardware(since(kParserOfJazzy)), in_humble(Effect::ignores, kUnread),
                           no_hardware_in_ros(since(kRosJazzy)),
                           in_ros_humble(Effect::ignores, kUnread)};

}  // namespace

extern constinit const Rule sml3605_hardware_mimic{
    .id = "SML3605",
    .name = "hardware-mimic",
    .severity = Severity::error,
    .summary = "A joint that mimics another has a command interface, or lacks the joint it mimics.",
    .remedy = "Delete its command interfaces, and add the joint that it mimics.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3605_hardware_mimic_file
