// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View transmission(model.robot->document, id);
    // With the type as an attribute it is one of PR2's, which have other rules.
    if (transmission.name() != "transmission" || transmission.attribute("type") != nullptr)
      continue;
    std::string missing;
    for (const std::string_view name : {"type", "joint", "actuator"}) {
      if (transmission.child(name) || has_slip(model, id, name)) continue;
      missing += (missing.empty() ? " has no " : " and no ") + quoted(name);
    }
    if (missing.empty()) continue;
    findings.report(transmission.name_span(), "this transmission" + missing)
        .notes.push_back("ros_control skips it, so the actuator does not come up");
  }
}

}  // namespace

extern constinit const Rule sml1448_transmission_incomplete{
    .id = "SML1448",
    .name = "transmission-incomplete",
    .severity = Severity::warning,
    .summary = "A transmission lacks its type, joint or actuator.",
    .why = "ros_control skips such a transmission with a message, ros2_control throws: the joint "
           "has no actuator.",
    .remedy = "Write `<type>`, `<joint name=\"...\">` and `<actuator name=\"...\">`.",
    .sources = "ros_control transmission_interface/src/transmission_parser.cpp; ros2_control "
               "transmission_parser.cpp.",
    .check_model = check};

}  // namespace smurf::rules
