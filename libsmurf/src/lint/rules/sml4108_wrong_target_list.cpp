// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml4108_wrong_target_list_file {
namespace {

struct List {
  std::string_view key;
  Field<NameList> Sensor::*list;
  NameKind kind;
};
constexpr List kLists[] = {{"links", &Sensor::links, NameKind::link},
                           {"joints", &Sensor::joints, NameKind::joint},
                           {"collisions", &Sensor::collisions, NameKind::collision},
                           {"motors", &Sensor::motors, NameKind::motor}};

/// Links and collisions are nodes of one numbering.
bool is_node(NameKind kind) { return kind == NameKind::link || kind == NameKind::collision; }

void check(const LinkedModel& model, Findings& findings) {
  for (const Sensor& sensor : model.annotations.sensors) {
    const auto wanted = sensor.type ? sensor_target(*sensor.type) : std::nullopt;
    if (!wanted || sensor.id.written) continue;  // `id` replaces the lists
    for (const List& list : kLists) {
      const Field<NameList>& names = sensor.*list.list;
      if (!names || names->empty() || list.kind == *wanted) continue;
      if (is_node(list.kind) && is_node(*wanted) && *wanted == NameKind::link) continue;
      const yaml::View mapping = mapping_of(model, sensor);
      if (!mapping) continue;
      const std::string kind(to_string(*wanted));
      findings
          .report(mapping.find(list.key).key_span(), "a " + *sensor.type + " measures " + kind +
                                                         "s, but " + subject("sensor", sensor) +
                                                         " lists " + quoted(list.key))
          .help("list them in `" + kind + "s`");
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes,
     "puts the indices of all listed objects into one list; a joint sensor then uses the index of "
     "a link as that of an unrelated joint, or its behaviour is undefined",
     "MARS smurf.cpp:161-181, LoadCenter.cpp:58-88"},
};

}  // namespace

extern constinit const Rule sml4108_wrong_target_list{
    .id = "SML4108",
    .name = "wrong-target-list",
    .severity = Severity::error,
    .summary = "A sensor lists targets of a kind that its type does not measure.",
    .remedy = "Use the list of the sensor's kind: `joints`, `links`, `collisions` or "
              "`motors`.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4108_wrong_target_list_file
