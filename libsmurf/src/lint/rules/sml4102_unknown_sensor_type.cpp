// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "ast/known_words.hpp"
#include "base/findings/readers.hpp"
#include "base/text/suggest.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml4102_unknown_sensor_type_file {
namespace {

constexpr Circumstance kPhobosSensor{"sensor of Phobos", &readers::phobos};

constexpr std::string_view kPhobosTypes[] = {"IMU", "GPS"};

void check(const LinkedModel& model, Findings& findings) {
  for (const Sensor& sensor : model.annotations.sensors) {
    if (!sensor.type) continue;
    const auto is_type = [&](std::string_view type) { return type == *sensor.type; };
    if (std::any_of(std::begin(kSensorTypes), std::end(kSensorTypes), is_type)) continue;
    Diagnostic& diagnostic = findings.report(
        sensor.type.span, "MARS does not know the sensor type " + quoted(*sensor.type));
    diagnostic.note(
        "it stops loading here: later objects, the pose and the anchor of the robot are missing");
    if (std::any_of(std::begin(kPhobosTypes), std::end(kPhobosTypes), is_type)) {
      diagnostic.when(kPhobosSensor);
      diagnostic.note("Phobos knows it");
      diagnostic.help(*sensor.type == "IMU" ? "the type of MARS is `NodeIMU`" : "");
    } else if (const auto near = only_nearest(*sensor.type, kSensorTypes)) {
      diagnostic.help("did you mean " + quoted(*near) + "?");
      diagnostic.fixes.push_back(
          {Applicability::unsafe, {{within_quotes(model, sensor.type.span), std::string(*near)}}});
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::breaks,
     "stops loading: all later objects are missing, and the pose, the anchor and the joint pose of the robot are skipped",
     "MARS SensorManager.cpp:351-360, smurf.cpp:1034-1037"},
    {&readers::phobos, Effect::takes, "knows the type", kRun, when(kPhobosSensor)},
    {&readers::phobos, Effect::refuses, "stops with an AttributeError",
     "Phobos sensor_representations.py, run"},
};

}  // namespace

extern constinit const Rule sml4102_unknown_sensor_type{
    .id = "SML4102",
    .name = "unknown-sensor-type",
    .severity = Severity::error,
    .summary = "A sensor has a type that MARS does not know.",
    .remedy =
        "Use one of the known types; they are case-sensitive. For a type of your own plug-in, set `--severity SML4102=info`.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4102_unknown_sensor_type_file
