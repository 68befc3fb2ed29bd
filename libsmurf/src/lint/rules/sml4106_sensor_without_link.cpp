// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "ast/keys.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules {
namespace {

constexpr std::string_view kTypes[] = {
    "Joint6DOF",     "CameraSensor", "RaySensor", "RotatingRaySensor", "MultiLevelLaserRangeFinder",
    "ScanningSonar", "HapticField"};

void check(const LinkedModel& model, Findings& findings) {
  for (const Sensor& sensor : model.annotations.sensors) {
    if (!sensor.type || sensor.link.written) continue;
    if (std::find(std::begin(kTypes), std::end(kTypes), *sensor.type) == std::end(kTypes)) continue;
    const yaml::View mapping = mapping_of(model, sensor);
    if (!mapping || mapping.find("URI") || mapping.find("URIs")) continue;
    if (!mapping.find("links") && has_misspelt(mapping, "link")) continue;
    findings.report(sensor.type.span, subject("sensor", sensor) + " has no `link`")
        .labels.push_back({place_to_add(mapping, "link"), "add it after this"});
  }
}

}  // namespace

extern constinit const Rule sml4106_sensor_without_link{
    .id = "SML4106",
    .name = "sensor-without-link",
    .severity = Severity::error,
    .summary = "A sensor that is fixed to a link names none.",
    .why = "MARS looks up node 0: a camera ends the program with an assertion, Joint6DOF "
           "dereferences a null pointer. MARS 2 stops with an exception at any sensor without it.",
    .remedy = "Add `link`.",
    .sources = "MARS smurf.cpp:272-283, CameraSensor.cpp; envire_smurf_loader Model.cpp:488.",
    .check_model = check};

}  // namespace smurf::rules
