// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "ast/keys.hpp"
#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml4106_sensor_without_link_file {
namespace {

constexpr Circumstance kCameraSensor{"CameraSensor"};

constexpr std::string_view kTypes[] = {
    "Joint6DOF",     "CameraSensor", "RaySensor", "RotatingRaySensor", "MultiLevelLaserRangeFinder",
    "ScanningSonar", "HapticField"};

void check(const LinkedModel& model, Findings& findings) {
  for (const Sensor& sensor : model.annotations.sensors) {
    if (!sensor.type || sensor.link.written) continue;
    if (std::find(std::begin(kTypes), std::end(kTypes), *sensor.type) == std::end(kTypes)) continue;
    const yaml::View mapping = mapping_of(model, sensor);
    if (!mapping || mapping.find("URI") || mapping.find("URIs")) continue;
    if (!mapping.find("links") && is_slip(mapping, "link", findings)) continue;
    Diagnostic& diagnostic =
        findings.report(sensor.type.span, subject("sensor", sensor) + " has no `link`");
    if (*sensor.type == "CameraSensor") diagnostic.when(kCameraSensor);
    diagnostic.label(place_to_add(mapping, "link"), "add it after this key");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes,
     "looks up node 0: a camera ends the program with an assertion, Joint6DOF dereferences a null pointer",
     "MARS smurf.cpp:272-283, CameraSensor.cpp"},
    {&readers::phobos, Effect::refuses, "stops with an assertion", kRun, when(kCameraSensor)},
    {&readers::phobos, Effect::breaks,
     "stops with an assertion at a camera, and keeps other sensors without a link", kRun},
    {&readers::mars2, Effect::crashes, "ends with an uncaught exception",
     "envire_smurf_loader Model.cpp:488"},
};

}  // namespace

extern constinit const Rule sml4106_sensor_without_link{
    .id = "SML4106",
    .name = "sensor-without-link",
    .severity = Severity::error,
    .summary = "A sensor that is fixed to a link names none.",
    .remedy = "Add `link`.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4106_sensor_without_link_file
