// SPDX-License-Identifier: BSD-3-Clause
#include <string_view>

#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3604_hardware_unknown_joint_file {
namespace {

void check(const LinkedModel& model, const Companions&, Findings& findings) {
  for (const Hardware& hardware : hardware_of(model)) {
    for (const HardwarePart& part : hardware.parts) {
      if (!part.is_joint() || part.element.attribute("name") == nullptr) continue;
      const Span place = place_of(part.element, "name");
      if (part.name.empty()) {
        findings
            .report(part.element.name_span(),
                    "a joint of " + title_of(hardware) + " has an empty name")
            .help("write the name of a joint of the robot");
        continue;
      }
      if (part.name.find("${") != std::string_view::npos) {  // SML1009
        findings.add_consequence(place);
        continue;
      }
      const urdf::Joint* joint = model.find_joint(part.name);
      if (joint == nullptr) {
        // Without a link, the file is a part of a robot.
        if (model.robot && model.robot->links.empty()) continue;
        const std::string subject = title_of(hardware);
        check_reference(model, NameKind::joint, part.name, place, subject.c_str(), findings);
      } else if (joint->type == urdf::JointType::fixed) {
        Diagnostic& found = findings.report(place, title_of(hardware) + " drives the joint " +
                                                       quoted(part.name) + ", which is fixed");
        found.label(joint->type_name.span, "its type")
            .help("delete it from `ros2_control`, or make the joint movable");
      }
    }
  }
}

constexpr std::string_view kLater = "loads the hardware, which fails later";

constexpr Fact kFacts[] = {no_hardware(since(kParserOfJazzy)), in_humble(Effect::breaks, kLater),
                           no_hardware_in_ros(since(kRosJazzy)),
                           in_ros_humble(Effect::breaks, kLater)};

}  // namespace

extern constinit const Rule sml3604_hardware_unknown_joint{
    .id = "SML3604",
    .name = "hardware-unknown-joint",
    .severity = Severity::error,
    .summary = "A `ros2_control` names a joint that the robot does not have, or that is fixed.",
    .remedy = "Write the name of a movable joint, or delete the joint there.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3604_hardware_unknown_joint_file
