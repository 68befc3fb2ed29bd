// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View transmission(model.robot->document, id);
    if (transmission.name() != "transmission") continue;
    for (const xml::View child : transmission) {
      const xml::Attribute* name = child.name() == "joint" ? child.attribute("name") : nullptr;
      if (name == nullptr) continue;
      check_reference(model, NameKind::joint, name->value(), name->value_span(), "a transmission",
                      findings);
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::loses,
     "ros_control finds no joint for its actuator and does not start the controller",
     "ros_control, read"},
    {&readers::drake, Effect::refuses, "refuses the file", "Drake detail_urdf_parser.cc:968"},
};

}  // namespace

extern constinit const Rule sml1443_transmission_joint_unknown{
    .id = "SML1443",
    .name = "transmission-joint-unknown",
    .severity = Severity::warning,
    .summary = "A transmission names a joint that the robot does not have.",
    .remedy = "Correct the name.",
    .sources = "14 of 322 files of the Tola/Corke dataset.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules
