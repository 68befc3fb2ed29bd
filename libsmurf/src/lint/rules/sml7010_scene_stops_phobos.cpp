// SPDX-License-Identifier: BSD-3-Clause

#include <map>

#include "base/findings/readers.hpp"
#include "link/scene_link.hpp"
#include "lint/annotation_queries.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml7010_scene_stops_phobos_file {
namespace {

void check_position(yaml::View position, Findings& findings) {
  if (!position || !position.is_mapping() || position.size() == 3) return;
  findings.report(position.key_span(), "Phobos expects a `position` of three numbers");
}

void check_entities(yaml::View entities, Findings& findings) {
  if (entities.is_null()) {
    findings.report(entities.key_span(), "Phobos finds no list in " + quoted(entities.key()))
        .help("write `[]` where there are no entities");
  }
  if (!entities.is_sequence()) return;
  for (const yaml::View entity : entities) {
    if (!entity.is_mapping()) continue;
    check_position(entity.find("position"), findings);
    report_name_read_as_value(entity, findings);
    report_number_keys(entity, findings);
  }
}

/// In MARS, included scenes may have the same name as each other, or as an entity.
void check_shared_names(const SceneFile& file, Findings& findings) {
  std::map<std::string_view, bool> is_scene_by_name;
  for (const Entity& entity : file.scene.entities) {
    if (!entity.name || entity.name->empty()) continue;
    const bool is_scene = kind_of(entity_type(entity)) == EntityKind::scene;
    const auto [known, is_new] = is_scene_by_name.emplace(*entity.name, is_scene);
    if (is_new || (!is_scene && !known->second)) continue;
    findings.report(entity.name.span, "Phobos already has an entity " + quoted(*entity.name));
  }
}

void check(const LinkedScene& scene, Findings& findings) {
  for (const SceneFile& file : scene.scenes) {
    check_shared_names(file, findings);
    const yaml::View root = file.document ? file.document->view() : yaml::View();
    if (!root || !root.is_mapping()) continue;
    for (const std::string_view list : {"entities", "smurfs", "smurfa"}) {
      if (const yaml::View entities = root.find(list)) check_entities(entities, findings);
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::takes, "accepts it", kRun},
    {&readers::mars2, Effect::takes, "accepts it", "MARS SMURFLoader.cpp"},
    {&readers::phobos, Effect::refuses, "stops with an exception", kRun},
};

}  // namespace

extern constinit const Rule sml7010_scene_stops_phobos{
    .id = "SML7010",
    .name = "scene-stops-phobos",
    .severity = Severity::error,
    .summary = "A scene is written in a way that stops Phobos 2.",
    .remedy = "Write it as the message says, or do not load it with Phobos.",
    .check_scene = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml7010_scene_stops_phobos_file
