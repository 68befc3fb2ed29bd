// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <initializer_list>

#include "ast/sections.hpp"
#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml7009_stops_phobos_file {
namespace {

/// Sensors of MARS without a class in Phobos.
constexpr std::string_view kUnknown[] = {
    "JointLoad",    "JointTorque",         "JointAVGTorque", "MultiLevelLaserRangeFinder",
    "NodeVelocity", "NodeAngularVelocity", "ScanningSonar",  "HapticField"};

/// Phobos has defaults for these, which a null replaces.
constexpr std::string_view kNeeded[] = {"id",     "horizontal_offset", "vertical_offset",
                                        "lasers", "opening_width",     "opening_height"};

/// Whether it has these members with values, and no others.
bool has_just(yaml::View mapping, std::initializer_list<std::string_view> names) {
  return mapping.size() == names.size() &&
         std::all_of(names.begin(), names.end(), [&](std::string_view name) {
           const yaml::View member = mapping.find(name);
           return member && !member.is_null();
         });
}

void check_offsets(yaml::View sensor, Findings& findings) {
  const yaml::View position = sensor.find("position_offset");
  const yaml::View orientation = sensor.find("orientation_offset");
  if (orientation && orientation.is_mapping() && !has_just(orientation, {"w", "x", "y", "z"})) {
    findings.report(orientation.key_span(), "Phobos reads a quaternion here, and nothing else")
        .help("write it with w, x, y, z");
  }
  if (position && (position.is_null() || position.is_mapping()) &&
      !has_just(position, {"x", "y", "z"})) {
    findings.report(position.key_span(), "Phobos expects a position with x, y, z");
    return;
  }
  const bool is_behind =
      orientation && position && orientation.key_span().begin < position.key_span().begin;
  if (!position || is_behind) return;
  findings
      .report(position.key_span(),
              "Phobos accepts `position_offset` only after `orientation_offset`")
      .help(orientation ? "write `orientation_offset` before it"
                        : "write `orientation_offset: {w: 1, x: 0, y: 0, z: 0}` before it");
}

void check_sensor(const Sensor& sensor, yaml::View mapping, Findings& findings) {
  const std::string_view type = sensor.type ? std::string_view(*sensor.type) : std::string_view();
  if (std::find(std::begin(kUnknown), std::end(kUnknown), type) != std::end(kUnknown)) {
    findings.report(sensor.type.span, "Phobos does not know the sensor type " + quoted(type));
    return;
  }
  const yaml::View joint = mapping.find("joint");
  if (type == "Joint6DOF" && joint) {
    findings.report(joint.key_span(), "Phobos accepts no `joint` here")
        .help("leave it out: the sensor measures the joint above its link");
  }
  for (const std::string_view key : kNeeded) {
    const yaml::View value = mapping.find(key);
    if (!value || !value.is_null() || type.ends_with("IMU")) continue;
    findings.report(value.key_span(), quoted(key) + " has no value, which Phobos needs");
  }
  check_offsets(mapping, findings);
}

void check_entries(yaml::View section, Findings& findings) {
  const std::string_view key = section.key();
  if (!section.is_sequence()) return;
  for (const yaml::View entry : section) {
    const bool has_names = key == "motors" || key == "sensors" || key == "poses";
    if (has_names) report_name_read_as_value(entry, findings);
    if (is_section_name(key) && key != "poses") report_number_keys(entry, findings);
    const bool is_link = key == "link" || key == "links";
    if (is_link && entry.is_mapping() && !entry.find("name")) {
      findings.report(entry.place(), "Phobos stops at an entry without `name`");
    }
  }
}

/// Sections that Phobos walks through; others may be null.
void check_sections(const LinkedModel& model, Findings& findings) {
  for (const auto& [file, section] : top_level_keys(model)) {
    if (file.kind != ModelFile::Kind::annotation) continue;
    const std::string_view key = section.key();
    const bool is_walked = is_section_name(key) && key != "lights" && key != "nodes" &&
                           key != "graphics" && key != "submodels";
    if (is_walked && section.is_null()) {
      findings.report(section.key_span(), "Phobos finds no list in " + quoted(key));
    }
    check_entries(section, findings);
  }
}

/// Phobos reads only mappings here, which is how it writes them.
void check_dependencies(const LinkedModel& model, Findings& findings) {
  for (const TopLevelKey& section : top_level_keys(model)) {
    if (section.value.key() != "submechanisms" || !section.value.is_sequence()) continue;
    for (const yaml::View entry : section.value) {
      const yaml::View joints =
          entry.is_mapping() ? entry.find("multi_joint_dependencies") : yaml::View();
      if (!joints || !joints.is_sequence()) continue;
      for (const yaml::View joint : joints) {
        const yaml::View leaders = joint.is_mapping() ? joint.find("depends_on") : yaml::View();
        if (!leaders || !leaders.is_sequence() || leaders.size() == 0) continue;
        if ((*leaders.begin()).is_mapping()) continue;
        findings.report(leaders.key_span(), "Phobos expects mappings in `depends_on`, not names")
            .help("write `{joint: NAME, multiplier: 1, offset: 0}`");
      }
    }
  }
}

void check_main_file(const LinkedModel& model, Findings& findings) {
  if (!model.has_main || !model.files.front().document) return;
  const yaml::View root = model.files.front().document->view();
  const yaml::View files = root && root.is_mapping() ? root.find("files") : yaml::View();
  if (!files || !files.is_scalar() || files.text().empty()) return;
  findings.report(files.place(), "Phobos expects a list of `files`")
      .help("make it an item: `- FILE`");
}

void check_robot(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  const xml::View robot = model.robot->document.view();
  const xml::View sensor = robot ? robot.child("sensor") : xml::View();
  if (!sensor) return;
  findings.report(sensor.name_span(), "Phobos accepts no `sensor` beside the links")
      .help("keep sensors in a `sensors` section");
}

void check(const LinkedModel& model, Findings& findings) {
  check_main_file(model, findings);
  check_robot(model, findings);
  check_sections(model, findings);
  check_dependencies(model, findings);
  for (const Sensor& sensor : model.annotations.sensors) {
    if (const yaml::View mapping = mapping_of(model, sensor)) {
      check_sensor(sensor, mapping, findings);
    }
  }
}

constexpr std::string_view kTakes = "accepts it";

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
    .summary = "A model is written in a way that stops Phobos 2.",
    .remedy = "Write it as the message says, or do not load it with Phobos.",
    .check_model = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml7009_stops_phobos_file
