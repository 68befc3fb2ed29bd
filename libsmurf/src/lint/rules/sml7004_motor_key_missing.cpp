// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/text/lists.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml7004_motor_key_missing_file {
namespace {

constexpr Circumstance kType{"type"};

/// The keys that MARS 2 reads without checking whether they are there.
std::vector<std::string_view> missing_keys(const Motor& motor) {
  std::vector<std::string_view> missing;
  const auto need = [&](bool is_written, std::string_view key) {
    if (!is_written) missing.push_back(key);
  };
  need(motor.type.written, "type");
  need(motor.min_value.written, "minValue");
  need(motor.max_value.written, "maxValue");
  need(motor.max_effort.written, "maxEffort");
  need(motor.max_speed.written, "maxSpeed");
  if (motor.type.value_or("") == "PID") {
    need(motor.p.written, "p");
    need(motor.i.written, "i");
    need(motor.d.written, "d");
  }
  return missing;
}

void check(const LinkedModel& model, Findings& findings) {
  for (const Motor& motor : model.annotations.motors) {
    const std::vector<std::string_view> missing = missing_keys(motor);
    if (missing.empty()) continue;
    Diagnostic& diagnostic =
        findings.report(motor.name.written ? motor.name.span : motor.span,
                        subject("motor", motor) + " has no " + listed(all_quoted(missing)));
    if (!motor.type.written) diagnostic.when(kType);
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::takes, "has defaults for most keys of a motor", "MARS MotorData.cpp"},
    {&readers::mars2, Effect::crashes, "ends with an uncaught exception",
     "envire_smurf_loader Model.cpp:443-456", when(kType)},
    {&readers::mars2, Effect::changes, "computes with uninitialised memory", "envire_types motors"},
};

}  // namespace

extern constinit const Rule sml7004_motor_key_missing{
    .id = "SML7004",
    .name = "motor-key-missing",
    .severity = Severity::error,
    .summary = "A motor lacks a key that a target requires.",
    .remedy = "Write the key.",
    .check_model = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml7004_motor_key_missing_file
