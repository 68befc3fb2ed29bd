// SPDX-License-Identifier: BSD-3-Clause
// The sensors that a page shows, with their fields of view.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "convert/sensor_views.hpp"
#include "smurf/linked.hpp"
#include "write/text/json_printer.hpp"

namespace smurf {

struct ViewerSensor {
  std::string name, type;
  std::size_t link = 0;  ///< the link that carries it
  SensorView view;
  const Sensor* annotation = nullptr;        ///< null: the element
  xml::ElementId element = xml::kNoElement;  ///< the <sensor> in <gazebo>
};

/// Sensors that are on a link. A sensor that measures several links occurs once for each.
std::vector<ViewerSensor> viewer_sensors(const LinkedModel& model);

/// The sensors among them that are annotations.
std::set<const Sensor*> sensors_on_page(const LinkedModel& model);

/// The settings of a <sensor> in <gazebo> that the page does not show.
std::vector<xml::View> unshown_settings(xml::View sensor);
/// Whether the page shows the setting of a key in the annotation of a sensor.
bool is_shown(const Sensor& sensor, std::string_view key);

/// Prints the motors and sensors of a model, at the links that they move or are on, for the tree.
void print_devices(const LinkedModel& model, JsonPrinter& json);
/// Prints the sensors of a model as described by web/viewer/scene.js, and those that are not
/// shown.
void print_sensors(const LinkedModel& model, JsonPrinter& json);

}  // namespace smurf
