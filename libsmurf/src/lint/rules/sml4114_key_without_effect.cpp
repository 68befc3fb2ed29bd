// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <initializer_list>

#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml4114_key_without_effect_file {
namespace {

template <class Entry>
void check_keys(const LinkedModel& model, const Entry& entry, std::string_view what,
                std::initializer_list<std::string_view> keys, Findings& findings) {
  const yaml::View mapping = mapping_of(model, entry);
  if (!mapping) return;
  for (const yaml::View value : mapping) {
    if (std::find(keys.begin(), keys.end(), value.key()) == keys.end()) continue;
    if (value.is_null() || value.is_repeated()) continue;
    findings.report(value.key_span(),
                    quoted(value.key()) + " of " + std::string(what) + " has no effect in MARS");
  }
}

/// The entry defines how to follow, but not which motor.
void check_follower(const LinkedModel& model, const Motor& motor, Findings& findings) {
  if (motor.mimic_motor.written || !motor.mimic_multiplier.written) return;
  const yaml::View mapping = mapping_of(model, motor);
  if (!mapping || has_misspelt(mapping, "mimic_motor")) return;
  Diagnostic& diagnostic = findings.report(mapping.find("mimic_multiplier").key_span(),
                                           "`mimic_multiplier` of " + subject("motor", motor) +
                                               " has no effect: there is no `mimic_motor`");
  diagnostic.severity = Severity::warning;
}

void check(const LinkedModel& model, Findings& findings) {
  for (const Motor& motor : model.annotations.motors) {
    check_keys(model, motor, "a motor", {"position", "axis", "index", "jointIndex"}, findings);
    check_follower(model, motor, findings);
  }
  for (const Sensor& sensor : model.annotations.sensors) {
    if (!sensor.type) continue;
    if (*sensor.type == "RaySensor") {
      check_keys(model, sensor, "a RaySensor",
                 {"height", "opening_height", "stepX", "stepY", "cols", "rows"}, findings);
    } else if (*sensor.type == "MultiLevelLaserRangeFinder") {
      check_keys(model, sensor, "a MultiLevelLaserRangeFinder", {"rate"}, findings);
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::ignores,
     "takes the control value before it stores the position, so the motor starts at 0",
     "MARS SimMotor.cpp:49-89", at("motors/position")},
    {&readers::mars, Effect::ignores, "ignores the factor of a mimic that names no motor",
     "MARS SimMotor.cpp", at("motors/mimic_multiplier")},
    {&readers::mars, Effect::ignores, "overwrites it when it loads the motor",
     "MARS smurf.cpp:261-264", at("motors")},
    {&readers::mars, Effect::ignores, "casts one row of rays, so their height has no effect",
     "MARS RaySensor.cpp", at("sensors")},
};

}  // namespace

extern constinit const Rule sml4114_key_without_effect{
    .id = "SML4114",
    .name = "key-without-effect",
    .severity = Severity::info,
    .summary = "A key that MARS reads has no effect.",
    .why = "Whoever changes such a value expects the robot to change, too.",
    .remedy = "Delete the key. A pose under `poses` sets the positions in which the robot starts.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4114_key_without_effect_file
