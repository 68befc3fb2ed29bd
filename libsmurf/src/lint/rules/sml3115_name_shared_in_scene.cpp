// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <string>
#include <vector>

#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml3115_name_shared_in_scene_file {
namespace {

/// How many instances have a motor, or a link, of a name.
using Counts = std::map<std::string_view, int>;

void count(const NameTable& table, int uses, Counts& counts) {
  for (const std::string_view name : table.names()) counts[name] += uses;
}

void check_name(const Counts& counts, std::string_view name, Span place, std::string_view kind,
                Findings& findings) {
  const auto found = counts.find(name);
  if (found == counts.end() || found->second < 2) return;
  findings.report(place, std::to_string(found->second) + " robots of the scene have a " +
                             std::string(kind) + " " + quoted(name) +
                             "; MARS uses the first for all of them");
}

void check_model(const LinkedModel& model, const Counts& motors, const Counts& links,
                 Findings& findings) {
  for (const Motor& motor : model.annotations.motors) {
    if (!motor.mimic_motor) continue;
    check_name(motors, *motor.mimic_motor, motor.mimic_motor.span, "motor", findings);
  }
  for (const Sensor& sensor : model.annotations.sensors) {
    if (!sensor.type || *sensor.type != "NodeCOM" || !sensor.link) continue;
    check_name(links, *sensor.link, sensor.link.span, "link", findings);
  }
  for (const Light& light : model.annotations.lights) {
    if (light.node_name)
      check_name(links, *light.node_name, light.node_name.span, "link", findings);
  }
  for (const CollisionAnnotation& entry : model.annotations.collisions) {
    const auto node = text_at(mapping_of(model, entry), "frictionDirNode");
    if (node) check_name(links, node->value, node->span, "link", findings);
  }
}

void check(const LinkedScene& scene, Findings& findings) {
  // A scene may use a large model thousands of times.
  std::vector<int> uses(scene.models.size());
  for (const Instance& instance : scene.instances) {
    if (instance.model) ++uses[to_size(*instance.model)];
  }
  Counts motors, links;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    count(scene.models[i].motor_names, uses[i], motors);
    count(scene.models[i].link_names, uses[i], links);
  }
  for (const LinkedModel& model : scene.models) check_model(model, motors, links, findings);
}

}  // namespace

extern constinit const Rule sml3115_name_shared_in_scene{
    .id = "SML3115",
    .name = "name-shared-in-scene",
    .severity = Severity::info,
    .summary = "Several robots of a scene share a name that MARS looks up in the whole scene.",
    .why =
        "The leader of a mimicking motor, the frame of a NodeCOM sensor, the node of a light and "
        "`frictionDirNode` are looked up by name among all robots of the simulation, and the first "
        "match is used: the motors of the second robot follow the first robot.",
    .remedy = "Give the motors or links of the robots different names, or use the model once.",
    .sources = "MARS MotorManager.cpp:274-281, 537-544; NodeCOMSensor.cpp:54; Simulator.cpp:784; "
               "SimNode.cpp:87.",
    .check_scene = check};

}  // namespace smurf::rules::sml3115_name_shared_in_scene_file
