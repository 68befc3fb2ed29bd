// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "ast/key_renames.hpp"
#include "ast/keys.hpp"
#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml4107_sensor_without_targets_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const Sensor& sensor : model.annotations.sensors) {
    if (!sensor.type || !sensor_target(*sensor.type)) continue;
    const auto is_given = [](const Field<NameList>* list) {
      return list->written && (!*list || !(*list)->empty());
    };
    const Field<NameList>* lists[] = {&sensor.id, &sensor.links, &sensor.joints, &sensor.collisions,
                                      &sensor.motors};
    if (std::any_of(std::begin(lists), std::end(lists), is_given)) continue;
    const yaml::View mapping = mapping_of(model, sensor);
    if (!mapping || mapping.find("URI") || mapping.find("URIs")) continue;
    const yaml::View targets = mapping.find("targets");
    const Span place = sensor.id.written ? sensor.id.span
                       : targets         ? targets.key_span()
                                         : sensor.type.span;
    Diagnostic& diagnostic = findings.report(
        place, subject("sensor", sensor) + " names no " +
                   std::string(to_string(*sensor_target(*sensor.type))) + " to measure");
    if (!targets && !sensor.id.written) {
      diagnostic.label(place_to_add(mapping, "id"), "add `id` after this key");
    }
    if (!targets) continue;
    diagnostic.help("did you mean `id` instead of `targets`?");
    KeyRenames(mapping).offer(diagnostic.fixes, targets, "id");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::loses,
     "collects the targets in `id`, `links`, `joints`, `collisions` and `motors`; without any of "
     "them the sensor delivers nothing",
     "MARS smurf.cpp:151-182, IDListConfig.h:60-64"},
};

}  // namespace

extern constinit const Rule sml4107_sensor_without_targets{
    .id = "SML4107",
    .name = "sensor-without-targets",
    .severity = Severity::warning,
    .summary = "A sensor does not name the objects that it measures.",
    .why = "`link` and `joint` are not targets.",
    .remedy = "List the measured objects in `id`.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4107_sensor_without_targets_file
