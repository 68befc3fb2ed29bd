// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "ast/key_renames.hpp"
#include "ast/scene_keys.hpp"
#include "ast/sections.hpp"
#include "base/suggest.hpp"
#include "link/scene_link.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules {
namespace {

bool takes(const KeySpec& spec, yaml::View value) {
  DiagnosticSink found;
  read_value(spec, value, {}, found);
  return found.diagnostics().empty();
}

/// `my_physics` is a name of one's own, no slip of the pen.
constexpr int kMostEdits = 2;

/// Words of other formats, and singulars, for keys of scenes and entities.
constexpr std::pair<std::string_view, std::string_view> kOtherWords[] = {
    {"entity", "entities"}, {"objects", "entities"},     {"models", "entities"},
    {"light", "lights"},    {"orientation", "rotation"}, {"rot", "rotation"},
    {"rpy", "rotation"},    {"quaternion", "rotation"},  {"translation", "position"},
    {"pos", "position"},    {"xyz", "position"},         {"radius", "extend"},
    {"size", "extend"},     {"extent", "extend"},        {"extents", "extend"},
};

/// Null when no reader has another word for it, or the value would not fit.
const KeySpec* meant_by_other_word(yaml::View value, KeyRenames& renames,
                                   std::span<const KeySpec> keys) {
  for (const auto& [word, key] : kOtherWords) {
    if (value.key() != word || renames.has(key)) continue;
    const KeySpec* spec = find_key({keys}, key);
    if (spec == nullptr || value.is_null()) continue;
    const bool is_list = spec->type == ValueType::list;
    if (!is_list || value.is_sequence()) return spec;
  }
  return nullptr;
}

/// The key that was meant: near, absent, and one that takes the value.
const KeySpec* meant_by(yaml::View value, KeyRenames& renames, std::span<const KeySpec> keys) {
  std::vector<std::string_view> names;
  for (const KeySpec& spec : keys) {
    if (spec.name != "URI") names.push_back(spec.name);  // nobody should write it
  }
  if (const KeySpec* other = meant_by_other_word(value, renames, keys)) return other;
  const auto near = nearest(value.key(), names);
  if (!near || renames.has(*near)) return nullptr;
  if (edit_distance(value.key(), *near, kMostEdits) > kMostEdits) return nullptr;
  const KeySpec* spec = find_key({keys}, *near);
  return takes(*spec, value) ? spec : nullptr;
}

void report(yaml::View value, const KeySpec& meant, KeyRenames& renames, Findings& findings) {
  Diagnostic& diagnostic = findings.report(
      value.key_span(), quoted(value.key()) + " is no key that readers of scenes know");
  diagnostic.help = "did you mean " + quoted(meant.name) + "?";
  if (takes(meant, value)) renames.offer(diagnostic.fixes, value, meant.name);
}

/// The keys of a mapping and of the mappings in it that have tables of their own.
void check_mapping(yaml::View mapping, std::span<const KeySpec> keys, Findings& findings) {
  KeyRenames renames(mapping);
  for (const yaml::View value : mapping) {
    const KeySpec* spec = find_key({keys}, value.key());
    if (spec == nullptr) {
      const KeySpec* meant = meant_by(value, renames, keys);
      if (meant != nullptr) report(value, *meant, renames, findings);
    } else if (spec->type == ValueType::mapping && value.is_mapping()) {
      check_mapping(value, spec->members.keys(), findings);
    }
  }
}

/// True when the missing file is reported, together with the slip.
bool is_reported_as_missing(const KeySpec& meant, const Entity& entity) {
  if (meant.name != "file") return false;
  const std::string type = entity_type(entity);
  return type.empty() || kind_of(type) != EntityKind::other || is_old_scene(type);
}

void check_entity(const LinkedScene& scene, const SceneFile& file, const Entity& entity,
                  Findings& findings) {
  if (has_schema(scene, entity_type(entity))) return;  // which says what keys there are
  KeyRenames renames(mapping_of(file, entity));
  const bool is_node = entity_type(entity) == "primitive";
  for (const CustomSection& extra : entity.extra) {
    const std::string& key = extra.name.value;
    if (find_key({all_entity_keys()}, key) || find_section(key)) continue;
    if (is_node && find_key({sections::node_keys()}, key)) continue;
    const yaml::View value(*file.document, extra.node);
    const KeySpec* meant = meant_by(value, renames, all_entity_keys());
    if (meant == nullptr && is_node) meant = meant_by(value, renames, sections::node_keys());
    if (meant == nullptr || is_reported_as_missing(*meant, entity)) continue;
    report(value, *meant, renames, findings);
  }
}

void check(const LinkedScene& scene, Findings& findings) {
  for (const SceneFile& file : scene.scenes) {
    if (!file.document) continue;
    const yaml::View root = file.document->view();
    if (root && root.is_mapping()) check_mapping(root, scene_keys(), findings);
  }
  for_each_entity(scene, [&](const SceneFile& file, const Entity& entity) {
    check_entity(scene, file, entity, findings);
  });
}

}  // namespace

extern constinit const Rule sml5028_misspelt_scene_key{
    .id = "SML5028",
    .name = "misspelt-scene-key",
    .severity = Severity::warning,
    .summary = "A key of a scene, an entity, physics or environment is almost a known one.",
    .why = "Every reader ignores keys it does not know, without a word: the robot stands at the "
           "origin, is not fixed, or is not there at all.",
    .remedy = "Write the key as suggested. Keys of your own may have any other name.",
    .sources = "MARS SMURFLoader.cpp:418-548, SimEntity.cpp:344-501.",
    .check_scene = check};

}  // namespace smurf::rules
