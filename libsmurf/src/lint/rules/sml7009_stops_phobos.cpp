// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "ast/sections.hpp"
#include "base/readers.hpp"
#include "lint/annotation_queries.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

/// Sensors of MARS without a class in Phobos.
constexpr std::string_view kUnknown[] = {
    "JointLoad",    "JointTorque",         "JointAVGTorque", "MultiLevelLaserRangeFinder",
    "NodeVelocity", "NodeAngularVelocity", "ScanningSonar",  "HapticField"};

void check_offsets(yaml::View sensor, Findings& findings) {
  const yaml::View position = sensor.find("position_offset");
  const yaml::View orientation = sensor.find("orientation_offset");
  if (orientation && orientation.is_mapping() && orientation.find("yaw")) {
    findings.report(orientation.key_span(), "Phobos reads no angles here").help =
        "write a quaternion with w, x, y, z";
  }
  const bool is_behind =
      orientation && position && orientation.key_span().begin < position.key_span().begin;
  if (!position || is_behind) return;
  findings
      .report(position.key_span(), "Phobos takes `position_offset` after `orientation_offset` only")
      .help = orientation ? "write `orientation_offset` before it"
                          : "write `orientation_offset: {w: 1, x: 0, y: 0, z: 0}` before it";
}

void check_sensor(const Sensor& sensor, yaml::View mapping, Findings& findings) {
  const std::string_view type = sensor.type ? std::string_view(*sensor.type) : std::string_view();
  if (std::find(std::begin(kUnknown), std::end(kUnknown), type) != std::end(kUnknown)) {
    findings.report(sensor.type.span, "Phobos does not know the sensor type " + quoted(type));
    return;
  }
  const yaml::View joint = mapping.find("joint");
  if (type == "Joint6DOF" && joint) {
    findings.report(joint.key_span(), "Phobos takes no `joint` here").help =
        "leave it out: the sensor measures the joint above its link";
  }
  const yaml::View ids = mapping.find("id");
  if (ids && ids.is_null()) findings.report(ids.key_span(), "Phobos finds no list in `id`");
  check_offsets(mapping, findings);
}

/// Sections that Phobos walks through; others may be null.
void check_sections(const LinkedModel& model, Findings& findings) {
  for (const ModelFile& file : model.files) {
    if (file.kind != ModelFile::Kind::annotation || !file.document) continue;
    const yaml::View root = file.document->view();
    if (!root || !root.is_mapping()) continue;
    for (const yaml::View section : root) {
      const std::string_view key = section.key();
      const bool is_walked = is_section_name(key) && key != "lights" && key != "nodes" &&
                             key != "graphics" && key != "submodels";
      if (is_walked && section.is_null()) {
        findings.report(section.key_span(), "Phobos finds no list in " + quoted(key));
      }
    }
  }
}

void check(const LinkedModel& model, Findings& findings) {
  check_sections(model, findings);
  for (const Sensor& sensor : model.annotations.sensors) {
    if (const yaml::View mapping = mapping_of(model, sensor)) {
      check_sensor(sensor, mapping, findings);
    }
  }
}

constexpr std::string_view kTakes = "takes it";

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::takes, kTakes, kRun},
    {&readers::mars2, Effect::takes, kTakes, "MARS smurf.cpp:257-485"},
    {&readers::envire, Effect::takes, kTakes, "MARS smurf.cpp:257-485"},
    {&readers::phobos, Effect::refuses, "stops with an exception", kRun},
};

}  // namespace

extern constinit const Rule sml7009_stops_phobos{
    .id = "SML7009",
    .name = "stops-phobos",
    .severity = Severity::error,
    .summary = "An annotation is written in a way that stops Phobos 2.",
    .remedy = "Write it as the message says, or keep it out of what Phobos loads.",
    .check_model = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules
