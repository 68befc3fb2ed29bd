// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "link/scene_link.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5025_primitive_key_ignored_file {
namespace {

/// Explicit defaults are fine.
bool has_effect(yaml::View value) {
  if (!value || value.is_null()) return false;
  const std::string_view text = value.is_scalar() ? value.text() : "?";
  return !text.empty() && text != "none" && !(value.key() == "parent" && text == "world");
}

void check(const LinkedScene& scene, Findings& findings) {
  for_each_entity(scene, [&](const SceneFile& file, const Entity& entity) {
    if (entity_type(entity) != "primitive") return;
    for (const std::string_view key : {"parent", "anchor", "pose"}) {
      const yaml::View value = mapping_of(file, entity).find(key);
      if (!has_effect(value)) continue;
      Diagnostic& diagnostic =
          findings.report(value.key_span(), quoted(key) + " has no effect on a primitive in MARS");
      if (key == "anchor") diagnostic.help("`movable: false` keeps a primitive where it is");
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::ignores,
     "registers no root node for a primitive, so that it is neither placed relative to another entity nor fixed to it",
     "MARS primitives.cpp:148-212, SimEntity.cpp:344-501"},
};

}  // namespace

extern constinit const Rule sml5025_primitive_key_ignored{
    .id = "SML5025",
    .name = "primitive-key-ignored",
    .severity = Severity::warning,
    .summary = "An entity of type primitive has `parent`, `anchor` or `pose`.",
    .remedy = "Write its position in the world and `movable: false`, or make it a URDF.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5025_primitive_key_ignored_file
