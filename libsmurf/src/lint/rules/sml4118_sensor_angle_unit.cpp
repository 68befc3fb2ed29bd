// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>

#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "lint/angle_queries.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml4118_sensor_angle_unit_file {
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
      "MARS reads " + quoted(key) + " of this sensor as " + text +
          (is_camera ? " degrees; is it in radians?" : " radians; is it in degrees?"));
  diagnostic.help(is_camera ? text + " rad are " + format_rounded(*value * factor, 6) + " degrees"
                            : text + " degrees are " + format_rounded(*value / factor, 6) + " rad");
}

/// A flat picture shows less than half a turn.
void check_camera(yaml::View mapping, Findings& findings) {
  constexpr double kHalfTurn = 180;
  for (const std::string_view key :
       {"opening_width", "opening_height", "opening_angle", "opening_angle2"}) {
    const auto value = number_at(mapping, key);
    if (!value || *value < kHalfTurn) continue;
    findings.report(mapping.find(key).span(), quoted(key) + " of a camera is " +
                                                  format_number(*value) +
                                                  " degrees, but pictures show less than 180");
  }
}

/// Roll, pitch and yaw are in degrees here, and in radians in most other places.
void check_turns(yaml::View orientation, Findings& findings) {
  if (!orientation || !orientation.is_mapping()) return;
  for (const std::string_view key : {"roll", "pitch", "yaw"}) {
    const auto value = number_at(orientation, key);
    const auto degrees = value ? degrees_of_radians(*value) : std::nullopt;
    if (!degrees) continue;
    Diagnostic& diagnostic = findings.report(
        orientation.find(key).span(), "MARS reads " + quoted(key) + " of this sensor as " +
                                          format_number(*value) + " degrees; is it in radians?");
    diagnostic.help("in degrees it is " + format_number(*degrees));
    diagnostic.fixes.push_back(
        {Applicability::unsafe, {{orientation.find(key).span(), format_number(*degrees)}}});
    return;
  }
}

void check(const LinkedModel& model, Findings& findings) {
  for (const Sensor& sensor : model.annotations.sensors) {
    if (!sensor.type) continue;
    const yaml::View mapping = mapping_of(model, sensor);
    if (!mapping) continue;
    for (const std::string_view key : {"orientation_offset", "rotation_offset", "orientation"}) {
      check_turns(mapping.find(key), findings);
    }
    const bool is_camera = *sensor.type == "CameraSensor";
    const bool is_ray = *sensor.type == "RaySensor" || *sensor.type == "RotatingRaySensor";
    if (is_camera) check_camera(mapping, findings);
    if (is_camera || is_ray) {
      for (const std::string_view key :
           {"opening_width", "opening_height", "opening_angle", "opening_angle2"}) {
        check_value(mapping, key, is_camera, findings);
      }
    }
    if (*sensor.type == "MultiLevelLaserRangeFinder") {
      check_value(mapping, "verticalOpeningAngle", false, findings);
      check_value(mapping, "horizontalOpeningAngle", false, findings);
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "reads the opening of a CameraSensor in degrees, and that of ray sensors in radians",
     "MARS CameraSensor.cpp:480-570, RaySensor.cpp, RotatingRaySensor.cpp"},
};

}  // namespace

extern constinit const Rule sml4118_sensor_angle_unit{
    .id = "SML4118",
    .name = "sensor-angle-unit",
    .severity = Severity::warning,
    .summary = "An angle of a sensor looks like radians where MARS reads degrees, or the reverse.",
    .why =
        "A camera that opens by 1.57 degrees sees almost nothing, and 90 rad are 14 turns. Roll, pitch and yaw of an offset are degrees.",
    .remedy = "Convert the value.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml4118_sensor_angle_unit_file
