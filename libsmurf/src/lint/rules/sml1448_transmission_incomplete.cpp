// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/ranges.hpp"
#include "base/text/words.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1448_transmission_incomplete_file {
namespace {

constexpr Circumstance kNotSimple{"not simple"};
constexpr Circumstance kEmptyType{"empty type"};
constexpr Circumstance kNoInterface{"no interface"};

/// Whether it has no such element, or one without its text or name. Drake takes an empty name for
/// an actuator.
bool lacks(xml::View transmission, std::string_view name) {
  const xml::View part = transmission.child(name);
  if (!part) return true;
  if (name == "type") return trimmed(part.text()).empty();
  const xml::Attribute* given = part.attribute("name");
  return given == nullptr || (name == "joint" && given->value().empty());
}

/// Whether a joint of the transmission lacks the interface that controllers ask for. ROS 2 reads
/// `ros2_control` instead.
bool lacks_interface(xml::View transmission) {
  for (const xml::View child : transmission) {
    if (child.name() == "joint" && !child.child("hardwareInterface")) return true;
  }
  return false;
}

bool has_ros2_control(const LinkedModel& model) {
  return ranges::any_of(model.robot->extensions, [&](xml::ElementId id) {
    return xml::View(model.robot->document, id).name() == "ros2_control";
  });
}

/// Whether an interface is written somewhere, or Gazebo loads ros_control. Drake reads
/// transmissions without interfaces.
bool is_for_ros_control(const LinkedModel& model) {
  return ranges::any_of(model.robot->extensions, [&](xml::ElementId id) {
    const xml::View part(model.robot->document, id);
    if (part.name() == "transmission") {
      for (const xml::View child : part) {
        if (child.child("hardwareInterface")) return true;
      }
      return false;
    }
    const xml::View plugin = part.name() == "gazebo" ? part.child("plugin") : xml::View{};
    const xml::Attribute* file = plugin ? plugin.attribute("filename") : nullptr;
    return file != nullptr && file->value().find("ros_control") != std::string_view::npos;
  });
}

void check_interfaces(const LinkedModel& model, Findings& findings) {
  if (!model.robot || has_ros2_control(model) || !is_for_ros_control(model)) return;
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View transmission(model.robot->document, id);
    if (transmission.name() != "transmission" || transmission.attribute("type") != nullptr)
      continue;
    if (lacks(transmission, "type") || lacks(transmission, "joint") ||
        lacks(transmission, "actuator") || !lacks_interface(transmission)) {
      continue;
    }
    findings
        .report_habit(transmission.child("joint").name_span(),
                      "the joint of this transmission has no `hardwareInterface`", "such joints")
        .when(kNoInterface)
        .help("add `<hardwareInterface>hardware_interface/EffortJointInterface"
              "</hardwareInterface>`, or that of another interface, to the joint");
  }
}

void check(const LinkedModel& model, Findings& findings) {
  check_interfaces(model, findings);
  if (!model.robot) return;
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View transmission(model.robot->document, id);
    // With the type as an attribute it is one of PR2's, which have other rules.
    if (transmission.name() != "transmission" || transmission.attribute("type") != nullptr)
      continue;
    std::string missing;
    for (const std::string_view name : {"type", "joint", "actuator"}) {
      if (!lacks(transmission, name)) continue;
      missing += (missing.empty() ? " has no " : " and no ") + quoted(name);
    }
    if (missing.empty()) continue;
    Diagnostic& diagnostic =
        findings.report(transmission.name_span(), "this transmission" + missing);
    const xml::View type = transmission.child("type");
    const bool is_simple = lacks(transmission, "type") ||
                           type.text().find("SimpleTransmission") != std::string_view::npos;
    if (!is_simple) diagnostic.when(kNotSimple);
    if (type && trimmed(type.text()).empty()) diagnostic.when(kEmptyType);
  }
}

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::loses, "ros_control skips the joint, and with it the actuator",
     "ros_control transmission_parser.cpp parseJoints", when(kNoInterface)},
    {&readers::drake, Effect::takes, "does not need it", kRun, when(kNoInterface)},
    {&readers::urdf, Effect::takes, "does not need it",
     "urdfdom, sdformat, DART, MuJoCo, Bullet and Pinocchio, run", when(kNoInterface)},
    {&readers::ros, Effect::loses, "ros_control skips it and does not load the actuator",
     "ros_control transmission_interface/src/transmission_parser.cpp"},
    {&readers::drake, Effect::loses, "makes actuators only for simple transmissions", kRun,
     when(kNotSimple)},
    {&readers::drake, Effect::crashes, "ends the process at an empty type", kRun, when(kEmptyType)},
    {&readers::drake, Effect::refuses, "refuses the file", kRun},
};

}  // namespace

extern constinit const Rule sml1448_transmission_incomplete{
    .id = "SML1448",
    .name = "transmission-incomplete",
    .severity = Severity::warning,
    .summary = "A transmission lacks its type, joint or actuator, or the interface of the joint.",
    .why = "The joint has no actuator.",
    .remedy = "Write `<type>`, `<joint name=\"...\">` and `<actuator name=\"...\">`.",
    .sources = "ros2_control transmission_parser.cpp.",
    .check_model = check,
    .facts = kFacts,
    .about = About::format};

}  // namespace smurf::rules::sml1448_transmission_incomplete_file
