// SPDX-License-Identifier: BSD-3-Clause
#include "convert/sensor_views.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/numbers/exact_math.hpp"
#include "base/numbers/numbers.hpp"
#include "base/numbers/quantity.hpp"
#include "convert/gazebo_sensors.hpp"
#include "convert/import.hpp"

namespace smurf {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
constexpr double kFullTurn = 2 * std::numbers::pi;
constexpr std::string_view kWide =
    "its field of view is not a rectangle: an opening is 180 degrees or more";
constexpr std::string_view kOther = "its field of view is not read";

/// The number in a child; none if it is absent or too large for computations.
std::optional<double> number_in(xml::View element, std::string_view child) {
  if (!element) return std::nullopt;
  const std::optional<double> number = parse_number(import::child_text(element, child));
  return number && is_quantity(*number) ? number : std::nullopt;
}

xml::View child_of(xml::View element, std::string_view name) {
  return element ? element.child(name) : xml::View();
}

std::optional<double> distance_in(xml::View element, std::string_view child) {
  const std::optional<double> distance = number_in(element, child);
  return distance && *distance >= 0 ? distance : std::nullopt;
}

std::optional<CameraView> camera(double width, std::optional<double> height) {
  if (!(width > 0) || !(width < 180) || !height) return std::nullopt;
  return CameraView{width * kRadians, *height * kRadians, {}, {}};
}

double whole(double count) { return std::max(1.0, std::round(count)); }

RayFan fan_of(xml::View scan, std::string_view direction) {
  const xml::View element = child_of(scan, direction);
  const auto angle = [&](std::string_view child) {
    return std::clamp(number_in(element, child).value_or(0), -kFullTurn, kFullTurn);
  };
  const auto [lowest, highest] = std::minmax({angle("min_angle"), angle("max_angle")});
  return {lowest, highest, whole(number_in(element, "samples").value_or(1))};
}

RayFan around(double middle, double opening, double count) {
  const double width = std::clamp(opening, 0.0, kFullTurn);
  return {middle - width / 2, middle + width / 2, whole(count)};
}

/// Rays are at equal angles of opening / number, so the outer ones are within the opening (MARS
/// RaySensor.cpp, and BasePolarIntersectionSensor in interfaces/sim).
ScanView rays(const SensorKeys& keys) {
  const double count = whole(keys.number("width", 1));
  const double opening = keys.number("opening_width", std::numbers::pi / 2);
  return {.across = around(0, opening * (count - 1) / count, count),
          .up = {},
          .nearest = {},
          .farthest = keys.number("max_distance", 100)};
}

/// The sensor turns about z, and a positive vertical angle looks down (MARS RotatingRaySensor.cpp).
ScanView rotating_rays(const SensorKeys& keys) {
  const double opening = keys.number("opening_width", kFullTurn);
  const double step = keys.number("horizontal_resolution", kRadians);
  return {.across = around(keys.number("horizontal_offset", 0), opening,
                           step > 0 ? std::min(opening / step, 1e6) : 1),
          .up = around(-keys.number("vertical_offset", 0.18622663118779495),
                       keys.number("opening_height", 40 * kRadians), keys.number("lasers", 32)),
          .nearest = keys.number("min_distance", 0.01),
          .farthest = keys.number("max_distance", 100)};
}

/// The scan begins along x and goes to the right (MARS MultiLevelLaserRangeFinder.cpp).
ScanView levels(const SensorKeys& keys) {
  const double count = whole(keys.number("numRaysHorizontal", 1900));
  const double opening = keys.number("horizontalOpeningAngle", kFullTurn * (count - 1) / count);
  return {.across = around(-opening / 2, opening, count),
          .up = around(0, keys.number("verticalOpeningAngle", 40 * kRadians),
                       keys.number("numRaysVertical", 32)),
          .nearest = {},
          .farthest = keys.number("maxDistance", 100)};
}

}  // namespace

std::optional<double> vertical_opening(double horizontal, double width, double height) {
  if (!(horizontal > 0) || !(horizontal < 180) || !(width > 0) || !(height > 0)) {
    return std::nullopt;
  }
  const auto [sine, cosine] = sine_cosine(horizontal * kRadians / 2);
  const double degrees = 2 * arc_tangent(sine * height, cosine * width) / kRadians;
  return degrees > 0 && degrees < 180 ? std::optional<double>(degrees) : std::nullopt;
}

std::optional<double> vertical_opening(const SensorKeys& keys) {
  for (const char* key : {"opening_angle2", "opening_height"}) {
    const auto given = keys.find(key);
    if (given && *given > 0) return *given < 180 ? given : std::nullopt;
  }
  return vertical_opening(keys.camera_opening(), keys.camera_width(), keys.camera_height());
}

SensorView view_of(xml::View sensor) {
  SensorView view{sensor_pose(sensor), {}, {}, {}};
  const std::string_view type = attribute_of(sensor, "type");
  if (type == "logical_camera" || type == "sonar") {
    view.why_unseen = kOther;
    return view;
  }
  if (const xml::View lens = sensor.child("camera");
      lens || type.find("camera") != std::string_view::npos || type == "depth") {
    const xml::View image = child_of(lens, "image");
    const double width = number_in(lens, "horizontal_fov").value_or(1.047) / kRadians;
    view.camera = camera(width, vertical_opening(width, number_in(image, "width").value_or(320),
                                                 number_in(image, "height").value_or(240)));
    if (!view.camera) {
      view.why_unseen = kWide;
      return view;
    }
    view.camera->nearest = distance_in(child_of(lens, "clip"), "near").value_or(0.1);
    view.camera->farthest = distance_in(child_of(lens, "clip"), "far").value_or(100);
    return view;
  }
  for (const char* kind : {"ray", "lidar"}) {
    const xml::View ray = sensor.child(kind);
    if (!ray) continue;
    const xml::View scan = ray.child("scan");
    const xml::View range = ray.child("range");
    view.scan = ScanView{fan_of(scan, "horizontal"), fan_of(scan, "vertical"),
                         distance_in(range, "min"), distance_in(range, "max")};
    return view;
  }
  return view;
}

SensorView view_of(const Sensor& sensor, yaml::View entry) {
  const SensorKeys keys(entry);
  const std::string type = sensor.type.value_or({});
  if (type == "CameraSensor") {
    SensorView view{
        keys.camera_pose(), camera(keys.camera_opening(), vertical_opening(keys)), {}, {}};
    if (!view.camera) view.why_unseen = kWide;
    if (const auto range = keys.find("range"); view.camera && range && *range > 0) {
      view.camera->farthest = range;
    }
    return view;
  }
  if (type == "RaySensor") return {{}, {}, rays(keys), {}};
  if (type == "RotatingRaySensor") {
    return {{{}, keys.rotation("rotation_offset")}, {}, rotating_rays(keys), {}};
  }
  if (type == "MultiLevelLaserRangeFinder") return {{}, {}, levels(keys), {}};
  if (type == "ScanningSonar" || type == "HapticField") return {{}, {}, {}, kOther};
  return {};
}

}  // namespace smurf
