// SPDX-License-Identifier: BSD-3-Clause
#include "ast/key_renames.hpp"
#include "ast/scene_keys.hpp"
#include "ast/sections.hpp"
#include "base/ranges.hpp"
#include "link/scene_link.hpp"
#include "lint/misspelt_key.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml4005_misspelt_key_file {
namespace {

Diagnostic& report(yaml::View value, const KeySpec& meant, KeyRenames& renames,
                   Findings& findings) {
  Diagnostic& diagnostic = findings.report(
      value.key_span(), quoted(value.key()) + " is not a key that readers of scenes know");
  diagnostic.help("did you mean " + quoted(meant.name) + "?");
  if (takes_value(meant, value)) renames.offer(diagnostic.fixes, value, meant.name);
  return diagnostic;
}

/// The keys of a mapping and of nested mappings with separate tables. `is_empty`: a scene in which
/// readers find no entities.
void check_mapping(yaml::View mapping, std::span<const KeySpec> keys, bool is_empty,
                   Findings& findings) {
  KeyRenames renames(mapping);
  for (const yaml::View value : mapping) {
    const KeySpec* spec = find_key({keys}, value.key());
    if (spec == nullptr) {
      const KeySpec* meant = misspelt_key(value, renames, keys);
      if (meant == nullptr) continue;
      Diagnostic& diagnostic = report(value, *meant, renames, findings);
      // Then the whole scene has no effect.
      if (is_empty && ranges::contains(kEntityLists, meant->name))
        diagnostic.severity = Severity::error;
    } else if (spec->type == ValueType::mapping && value.is_mapping()) {
      check_mapping(value, spec->members.keys(), false, findings);
    }
  }
}

/// True when SML5005 reports the missing file together with the misspelling.
bool is_reported_as_missing(const KeySpec& meant, const Entity& entity) {
  if (meant.name != "file") return false;
  const std::string type = entity_type(entity);
  return type.empty() || kind_of(type) != EntityKind::other || is_old_scene(type);
}

void check_entity(const LinkedScene& scene, const SceneFile& file, const Entity& entity,
                  Findings& findings) {
  if (has_schema(scene, entity_type(entity))) return;  // another finding lists the known keys
  KeyRenames renames(mapping_of(file, entity));
  const bool is_node = entity_type(entity) == "primitive";
  for (const CustomSection& extra : entity.extra) {
    const std::string& key = extra.name.value;
    if (find_key({all_entity_keys()}, key) || find_section(key)) continue;
    if (is_node && find_key({sections::node_keys()}, key)) continue;
    const yaml::View value(*file.document, extra.node);
    const KeySpec* meant = misspelt_key(value, renames, all_entity_keys());
    if (meant == nullptr && is_node) meant = misspelt_key(value, renames, sections::node_keys());
    if (meant == nullptr || is_reported_as_missing(*meant, entity)) continue;
    report(value, *meant, renames, findings);
  }
}

void check(const LinkedScene& scene, Findings& findings) {
  for (const SceneFile& file : scene.scenes) {
    if (!file.document) continue;
    const yaml::View root = file.document->view();
    if (root && root.is_mapping()) {
      check_mapping(root, scene_keys(), file.scene.entities.empty(), findings);
    }
  }
  for_each_entity(scene, [&](const SceneFile& file, const Entity& entity) {
    check_entity(scene, file, entity, findings);
  });
}

}  // namespace

extern constinit const Rule sml4005_misspelt_key{
    .id = "SML4005",
    .name = "misspelt-key",
    .severity = Severity::warning,
    .summary = "A key unknown to all readers resembles a known one.",
    .why =
        "Every reader looks keys up by their exact names: a misspelt one has no effect. In a scene, "
        "the robot is at the origin, is not fixed, or is missing.",
    .remedy = "Correct the key, or give a custom key a name that differs more.",
    .sources = "configmaps (run); MARS MotorData.cpp, NodeData.cpp:98-286, JointData.cpp:89-164, "
               "SMURFLoader.cpp:418-548, SimEntity.cpp:344-501.",
    .check_scene = check};

}  // namespace smurf::rules::sml4005_misspelt_key_file
