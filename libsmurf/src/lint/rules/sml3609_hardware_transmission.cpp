// SPDX-License-Identifier: BSD-3-Clause
#include "base/text/counted.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3609_hardware_transmission_file {
namespace {

void check_transmission(const Hardware& hardware, xml::View element, Findings& findings) {
  const std::string_view name = attribute_text(element, "name");
  const std::string title = (name.empty() ? "a transmission" : "transmission " + quoted(name)) +
                            " of " + title_of(hardware);
  std::size_t joints = 0;
  for (const xml::View child : element) {
    if (child.name() != "joint") continue;
    ++joints;
    const std::string_view joint = attribute_text(child, "name");
    if (child.attribute("name") == nullptr || hardware.find_joint(joint) != nullptr) continue;
    std::vector<std::string_view> known;
    for (const HardwarePart& part : hardware.parts) {
      if (part.is_joint()) known.push_back(part.name);
    }
    const Span place = joint.empty() ? child.name_span() : place_of(child, "name");
    Diagnostic& found = findings.report(place, title + " names the joint " + quoted(joint) +
                                                   ", which this ros2_control does not have");
    if (const auto near = findings.suggest(joint, known)) {
      found.help("did you mean " + quoted(*near) + "?");
      found.fixes.push_back({Applicability::unsafe, {{place, std::string(*near)}}});
    } else {
      found.help("add the joint to this `ros2_control`");
    }
  }
  if (hardware.type != "actuator" || joints == 1) return;
  findings
      .report(element.name_span(),
              title + " has " + counted(joints, "joint") + ", but an actuator has exactly one")
      .help("write one joint");
}

void check(const LinkedModel& model, const Companions&, Findings& findings) {
  for (const Hardware& hardware : hardware_of(model)) {
    for (const xml::View child : hardware.element) {
      if (child.name() == "transmission") check_transmission(hardware, child, findings);
    }
  }
}

constexpr Fact kFacts[] = {no_hardware(), no_hardware_in_ros()};

}  // namespace

extern constinit const Rule sml3609_hardware_transmission{
    .id = "SML3609",
    .name = "hardware-transmission",
    .severity = Severity::error,
    .summary = "A transmission in `ros2_control` names a joint that is not in it.",
    .remedy = "Add the joint to the same `ros2_control`, or correct the name.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3609_hardware_transmission_file
