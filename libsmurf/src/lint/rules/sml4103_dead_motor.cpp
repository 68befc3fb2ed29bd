// SPDX-License-Identifier: BSD-3-Clause
#include "lint/annotation_queries.hpp"

namespace smurf::rules {
namespace {

struct Need {
  std::string_view key, old_key;
  std::string_view consequence;
};
constexpr Need kSpeed{"maxSpeed", "maximumVelocity", "does not move in MARS"};
constexpr Need kEffort{"maxEffort", "motorMaxForce", "is limp in MARS"};

void check_need(const LinkedModel& model, const Motor& motor, const Need& need,
                Findings& findings) {
  const yaml::View mapping = mapping_of(model, motor);
  if (!mapping) return;
  yaml::View value = mapping.find(need.key);
  if (!value) value = mapping.find(need.old_key);
  if (value && !value.is_null()) {
    if (value.number() != 0) return;  // what is no number is reported where it is read
    findings.report(value.span(), subject("motor", motor) + " " + std::string(need.consequence) +
                                      ": " + quoted(value.key()) + " is 0");
    return;
  }
  if (mapping.find("URI") || mapping.find("URIs") || has_misspelt(mapping, need.key)) return;
  const Span place = motor.name.written ? motor.name.span : (*mapping.begin()).key_span();
  findings.report(place, subject("motor", motor) + " has no " + quoted(need.key) + " and " +
                             std::string(need.consequence));
}

void check(const LinkedModel& model, Findings& findings) {
  for (const Motor& motor : model.annotations.motors) {
    if (control_in_mars(motor) != MotorControl::torque) check_need(model, motor, kSpeed, findings);
    check_need(model, motor, kEffort, findings);
  }
}

}  // namespace

extern constinit const Rule sml4103_dead_motor{
    .id = "SML4103",
    .name = "dead-motor",
    .severity = Severity::error,
    .summary = "A motor has no speed or no effort, so that it never moves.",
    .why = "MARS clamps the speed to `maxSpeed` and the force of the joint to `maxEffort`; "
           "both are 0 when they are absent. A torque motor needs the effort only.",
    .remedy = "Write both; the limits of the URDF joint are a good start.",
    .sources = "MARS MotorData.cpp:85-86, SimMotor.cpp:434-444.",
    .check_model = check};

}  // namespace smurf::rules
