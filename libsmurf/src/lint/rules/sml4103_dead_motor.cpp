// SPDX-License-Identifier: BSD-3-Clause
#include "ast/keys.hpp"
#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml4103_dead_motor_file {
namespace {

struct Need {
  std::string_view key, old_key;
  std::string_view consequence;
};
constexpr Need kSpeed{"maxSpeed", "maximumVelocity", "does not move in MARS"};
constexpr Need kEffort{"maxEffort", "motorMaxForce", "produces no force in MARS"};
constexpr Need kGain{"p", "p", "does not move in MARS"};

void check_need(const LinkedModel& model, const Motor& motor, const Need& need,
                Findings& findings) {
  const yaml::View mapping = mapping_of(model, motor);
  if (!mapping || mapping.size() == 0) return;  // without any key: reported where it is read
  yaml::View value = mapping.find(need.key);
  if (!value) value = mapping.find(need.old_key);
  if (value && !value.is_null()) {
    if (value.number() != 0) return;  // the reader of the value reports texts that are not numbers
    findings.report(value.span(), subject("motor", motor) + " " + std::string(need.consequence) +
                                      ": " + quoted(value.key()) + " is 0");
    return;
  }
  if (mapping.find("URI") || mapping.find("URIs") || has_misspelt(mapping, need.key)) return;
  const Span place = motor.name.written ? motor.name.span : (*mapping.begin()).key_span();
  findings
      .report(place, subject("motor", motor) + " has no " + quoted(need.key) + " and " +
                         std::string(need.consequence))
      .label(place_to_add(mapping, need.key), "add it after this key");
}

/// Models that are not meant for MARS have no gains at all; a gain of 0 was written on purpose.
bool has_zero_gain(const LinkedModel& model, const Motor& motor) {
  const bool is_zero = motor.p && *motor.p == 0 && motor.i.value_or(0) == 0;
  return is_zero && mapping_of(model, motor) && control_in_mars(motor) == MotorControl::position;
}

void check(const LinkedModel& model, Findings& findings) {
  for (const Motor& motor : model.annotations.motors) {
    if (control_in_mars(motor) != MotorControl::torque) check_need(model, motor, kSpeed, findings);
    check_need(model, motor, kEffort, findings);
    if (has_zero_gain(model, motor)) check_need(model, motor, kGain, findings);
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "clamps the speed to `maxSpeed` and the force of the joint to `maxEffort`, which are 0 when "
     "absent; a position motor moves at `p` times its error",
     "MARS MotorData.cpp:85-86, SimMotor.cpp:352-407, 434-444"},
    {&readers::phobos, Effect::takes, "uses the effort and speed of the joint's limit",
     "Phobos a613e31, run"},
};

}  // namespace

extern constinit const Rule sml4103_dead_motor{
    .id = "SML4103",
    .name = "dead-motor",
    .severity = Severity::error,
    .summary = "A motor has no speed, no effort or no gain, so it never moves.",
    .remedy = "Write the missing values; the limits of the URDF joint are a good start.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml4103_dead_motor_file
