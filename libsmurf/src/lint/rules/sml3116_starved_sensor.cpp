// SPDX-License-Identifier: BSD-3-Clause

#include <map>

#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml3116_starved_sensor_file {
namespace {

using Silent = std::map<std::string_view, Span>;

template <class Entries>
void add_silent(const LinkedModel& model, const Entries& entries, Silent& silent) {
  for (const auto& entry : entries) {
    const yaml::View mapping = mapping_of(model, entry);
    const yaml::View value = mapping ? mapping.find("noDataPackage") : yaml::View();
    if (!entry.name || !value || value.boolean() != true) continue;
    silent.emplace(*entry.name, value.span());
  }
}

void check(const LinkedModel& model, Findings& findings) {
  Silent silent;
  add_silent(model, model.annotations.links, silent);
  add_silent(model, model.annotations.nodes, silent);
  add_silent(model, model.annotations.collisions, silent);
  if (silent.empty()) return;
  for (const Sensor& sensor : model.annotations.sensors) {
    if (!sensor.type || !sensor.type->starts_with("Node")) continue;
    for (const Field<NameList>* list : {&sensor.id, &sensor.links, &sensor.collisions}) {
      if (!*list) continue;
      for (const Spanned<std::string>& name : **list) {
        const auto found = silent.find(name.value);
        if (found == silent.end()) continue;
        Diagnostic& diagnostic =
            findings.report(name.span, quoted(name.value) + " publishes no data for " +
                                           subject("sensor", sensor) + " to read");
        diagnostic.label(found->second, "switched off here");
      }
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::loses,
     "does not publish a node with `noDataPackage: true`, and sensors that wait for its data deliver nothing",
     "MARS SimNode.cpp:100"},
};

}  // namespace

extern constinit const Rule sml3116_starved_sensor{
    .id = "SML3116",
    .name = "starved-sensor",
    .severity = Severity::warning,
    .summary = "A sensor reads a node that publishes no data.",
    .remedy = "Set `noDataPackage: false` for nodes that sensors read.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3116_starved_sensor_file
