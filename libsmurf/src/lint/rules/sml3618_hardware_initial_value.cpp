// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <string_view>

#include "base/numbers/numbers.hpp"
#include "base/text/words.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3618_hardware_initial_value_file {
namespace {

constexpr Circumstance kBeyond{"beyond"};
constexpr Circumstance kAttribute{"attribute"};
constexpr Circumstance kInJoint{"in the joint"};

void check_value(const urdf::Joint& joint, xml::View value, const std::string& title,
                 Findings& findings) {
  const auto number = parse_number(trimmed(value.text()));
  const bool is_bounded =
      joint.type == urdf::JointType::revolute || joint.type == urdf::JointType::prismatic;
  if (!number || !is_bounded || !joint.limit) return;
  const urdf::Limit& limit = *joint.limit;
  const double lower = limit.lower.value_or(0), upper = limit.upper.value_or(0);
  if (lower > upper || (*number >= lower && *number <= upper)) return;
  const bool is_low = *number < lower;
  findings
      .report(value.text_span(), title + " starts at " + format_rounded(*number) + ", " +
                                     (is_low ? "below its lower" : "above its upper") + " limit " +
                                     format_rounded(is_low ? lower : upper))
      .when(kBeyond)
      .help("write a value from " + format_rounded(lower) + " to " + format_rounded(upper));
}

void check_part(const LinkedModel& model, const HardwarePart& part, const Hardware& hardware,
                Findings& findings) {
  const urdf::Joint* joint = part.is_joint() ? model.find_joint(part.name) : nullptr;
  const std::string title = title_of(part, hardware);
  for (const HardwareInterface& one : part.interfaces) {
    if (const xml::Attribute* written = one.element.attribute("initial_value")) {
      findings
          .report(written->name_span(), title + " has `initial_value` as an attribute, which "
                                                "nothing reads")
          .when(kAttribute)
          .help("write `<param name=\"initial_value\">" + std::string(written->value()) +
                "</param>` in the interface");
    }
    const xml::View value = one.parameter_element("initial_value");
    if (value && joint != nullptr && !one.is_command && one.name == "position") {
      check_value(*joint, value, title, findings);
    }
  }
  if (!part.is_joint()) return;
  for (const xml::View child : part.element) {
    if (child.name() != "param" || attribute_text(child, "name") != "initial_position") continue;
    findings
        .report(place_of(child, "name"),
                "`initial_position` of " + title + " is read in Humble only, by mock_components")
        .when(kInJoint)
        .help("write `<param name=\"initial_value\">" + std::string(trimmed(child.text())) +
              "</param>` in `<state_interface name=\"position\">`")
        .severity = Severity::info;
  }
}

void check(const LinkedModel& model, const Companions&, Findings& findings) {
  for (const Hardware& hardware : hardware_of(model)) {
    for (const HardwarePart& part : hardware.parts) check_part(model, part, hardware, findings);
  }
}

constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::changes,
     "starts at this value, from which MoveIt refuses every plan",
     "ros2_control mock_components generic_system.cpp; moveit2 check_start_state_bounds.cpp",
     when(kBeyond)},
    {&readers::ros2_control, Effect::changes, "starts the joint at 0",
     "ros2_control hardware_interface/src/component_parser.cpp", when(kAttribute)},
    {&readers::ros2_control, Effect::takes, "starts at this value, in mock_components",
     "ros2_control generic_system.cpp, branch humble", when(kInJoint).before(kParserOfJazzy)},
    {&readers::ros2_control, Effect::changes, "starts the joint at 0",
     "ros2_control generic_system.cpp, branch jazzy; gz_ros2_control gz_system.cpp",
     when(kInJoint)},
};

}  // namespace

extern constinit const Rule sml3618_hardware_initial_value{
    .id = "SML3618",
    .name = "hardware-initial-value",
    .severity = Severity::warning,
    .summary = "The initial value of a joint is beyond its limits, or where nothing reads it.",
    .remedy = "Write `<param name=\"initial_value\">` in the state interface, within the limits.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3618_hardware_initial_value_file
