// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <initializer_list>

#include "lint/annotation_queries.hpp"

namespace smurf::rules {
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

}  // namespace

extern constinit const Rule sml4114_key_without_effect{
    .id = "SML4114",
    .name = "key-without-effect",
    .severity = Severity::info,
    .summary = "A key that MARS reads has no effect.",
    .why =
        "MARS overwrites `axis`, `index` and `jointIndex` of a motor when it loads it, and takes "
        "the control value before it stores `position`, so the motor starts at 0. MARS ignores the "
        "factor of a mimic that names no motor. A RaySensor casts one row of rays, so its height "
        "has no effect.",
    .remedy = "Delete the key. A pose under `poses` sets the positions in which the robot starts.",
    .sources = "MARS smurf.cpp:261-264, SimMotor.cpp:49-89, RaySensor.cpp.",
    .check_model = check};

}  // namespace smurf::rules
