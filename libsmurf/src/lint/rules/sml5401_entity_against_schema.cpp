// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "base/findings/rules.hpp"
#include "link/scene_link.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"
#include "smurf/user_schemas.hpp"

namespace smurf::rules::sml5401_entity_against_schema_file {
namespace {

/// The reader of the scene reports values that are not a position or rotation at all.
bool is_reported(const Entity& entity, const Diagnostic& diagnostic) {
  const bool is_position = entity.position.written && !entity.position;
  const bool is_rotation = entity.rotation.form == RotationForm::invalid;
  return (is_position && diagnostic.span == entity.position.span) ||
         (is_rotation && diagnostic.span == entity.rotation.span);
}

void check(const LinkedScene& scene, Findings& findings) {
  if (scene.schemas == nullptr) return;
  SchemaWork work;
  for_each_entity(scene, [&](const SceneFile& file, const Entity& entity) {
    DiagnosticSink sink;
    Findings found(rules::sml5401_entity_against_schema, findings.tolerance(), sink,
                   findings.answers());
    scene.schemas->check_entity(entity_type(entity), mapping_of(file, entity), work, found);
    for (Diagnostic& diagnostic : sink.take()) {
      if (is_reported(entity, diagnostic)) continue;
      Diagnostic& reported = findings.report(diagnostic.span, {});
      reported = std::move(diagnostic);
    }
  });
}

}  // namespace

extern constinit const Rule sml5401_entity_against_schema{
    .id = "SML5401",
    .name = "entity-against-schema",
    .severity = Severity::error,
    .summary = "An entity breaks the schema that was registered for its type.",
    .why = "The schema describes the values that the plug-in for this type understands; the effect "
           "of other values is unknown.",
    .remedy = "Change the value, or the schema when it is too strict.",
    .sources = "The schema that the label names.",
    .check_scene = check};

}  // namespace smurf::rules::sml5401_entity_against_schema_file
