// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1448_transmission_incomplete_file {
namespace {

constexpr Circumstance kNotSimple{"not simple"};

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
    Diagnostic& diagnostic =
        findings.report(transmission.name_span(), "this transmission" + missing);
    const xml::View type = transmission.child("type");
    const bool is_simple =
        !type || type.text().find("SimpleTransmission") != std::string_view::npos;
    if (!is_simple) diagnostic.when(kNotSimple);
  }
}

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::loses, "ros_control skips it and does not load the actuator",
     "ros_control transmission_interface/src/transmission_parser.cpp"},
    {&readers::drake, Effect::loses, "makes actuators only for simple transmissions",
     "Drake detail_urdf_parser.cc:930-936", when(kNotSimple)},
    {&readers::drake, Effect::refuses, "refuses the file", "Drake detail_urdf_parser.cc:915-964"},
};

}  // namespace

extern constinit const Rule sml1448_transmission_incomplete{
    .id = "SML1448",
    .name = "transmission-incomplete",
    .severity = Severity::warning,
    .summary = "A transmission lacks its type, joint or actuator.",
    .why = "The joint has no actuator.",
    .remedy = "Write `<type>`, `<joint name=\"...\">` and `<actuator name=\"...\">`.",
    .sources = "ros2_control transmission_parser.cpp.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1448_transmission_incomplete_file
