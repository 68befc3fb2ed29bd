// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>

#include "base/numbers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules {
namespace {

constexpr double kFullTurn = 2 * std::numbers::pi;

void check_value(yaml::View mapping, std::string_view key, bool is_camera, Findings& findings) {
  const auto value = number_at(mapping, key);
  if (!value || *value <= 0) return;
  const bool is_suspect = is_camera ? *value <= std::numbers::pi && std::trunc(*value) != *value
                                    : *value > kFullTurn + 0.01;
  if (!is_suspect) return;
  const std::string text = format_number(*value);
  const double factor = 180 / std::numbers::pi;
  Diagnostic& diagnostic = findings.report(
      mapping.find(key).span(),
      "MARS takes " + quoted(key) + " of this sensor as " + text +
          (is_camera ? " degrees; is it in radians?" : " radians; is it in degrees?"));
  diagnostic.help = is_camera
                        ? text + " rad are " + format_rounded(*value * factor, 6) + " degrees"
                        : text + " degrees are " + format_rounded(*value / factor, 6) + " rad";
}

void check(const LinkedModel& model, Findings& findings) {
  for (const Sensor& sensor : model.annotations.sensors) {
    if (!sensor.type) continue;
    const bool is_camera = *sensor.type == "CameraSensor";
    const bool is_ray = *sensor.type == "RaySensor" || *sensor.type == "RotatingRaySensor";
    if (!is_camera && !is_ray) continue;
    const yaml::View mapping = mapping_of(model, sensor);
    for (const std::string_view key :
         {"opening_width", "opening_height", "opening_angle", "opening_angle2"}) {
      check_value(mapping, key, is_camera, findings);
    }
  }
}

}  // namespace

extern constinit const Rule sml4118_sensor_angle_unit{
    .id = "SML4118",
    .name = "sensor-angle-unit",
    .severity = Severity::warning,
    .summary = "The opening of a sensor looks like radians where MARS takes degrees, or the "
               "reverse.",
    .why = "MARS takes the opening of a CameraSensor in degrees, that of ray sensors in "
           "radians: 1.57 degrees is a slit, 90 rad are 14 turns.",
    .remedy = "Convert the value.",
    .sources = "MARS CameraSensor.cpp:480-570, RaySensor.cpp, RotatingRaySensor.cpp.",
    .check_model = check};

}  // namespace smurf::rules
