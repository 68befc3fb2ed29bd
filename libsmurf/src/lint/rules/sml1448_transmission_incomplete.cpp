// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/text/words.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1448_transmission_incomplete_file {
namespace {

constexpr Circumstance kNotSimple{"not simple"};
constexpr Circumstance kEmptyType{"empty type"};

/// Whether it has no such element, or one without its text or name. Drake takes an empty name for
/// an actuator.
bool lacks(xml::View transmission, std::string_view name) {
  const xml::View part = transmission.child(name);
  if (!part) return true;
  if (name == "type") return trimmed(part.text()).empty();
  const xml::Attribute* given = part.attribute("name");
  return given == nullptr || (name == "joint" && given->value().empty());
}

void check(const LinkedModel& model, Findings& findings) {
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
    .summary = "A transmission lacks its type, joint or actuator.",
    .why = "The joint has no actuator.",
    .remedy = "Write `<type>`, `<joint name=\"...\">` and `<actuator name=\"...\">`.",
    .sources = "ros2_control transmission_parser.cpp.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1448_transmission_incomplete_file
