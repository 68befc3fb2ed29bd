// SPDX-License-Identifier: BSD-3-Clause
#include <vector>

#include "base/edits.hpp"
#include "base/readers.hpp"
#include "base/suggest.hpp"
#include "link/scene_link.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"
#include "smurf/archive_files.hpp"
#include "smurf/user_schemas.hpp"

namespace smurf::rules {
namespace {

constexpr std::string_view kTypes[] = {"smurf", "urdf", "smurfs",    "smurfa",  "scn",
                                       "scene", "yml",  "primitive", "particle"};

void check(const LinkedScene& scene, Findings& findings) {
  std::vector<std::string_view> known(std::begin(kTypes), std::end(kTypes));
  if (scene.schemas != nullptr) {
    const std::vector<std::string_view> own = scene.schemas->entity_types();
    known.insert(known.end(), own.begin(), own.end());
  }
  for_each_entity(scene, [&](const SceneFile&, const Entity& entity) {
    const std::string type = entity_type(entity);
    if (is_archive_type(type)) return;  // another rule's
    if (has_schema(scene, type)) return;
    const auto near = nearest(type, known);
    if (!near) return;
    const bool is_written = entity.type && !entity.type->empty();
    const Span place = type_place(entity);
    Diagnostic& diagnostic =
        findings.report(place, "the type of " + title(entity) + " is " + quoted(type) +
                                   ", which MARS does not know");
    diagnostic.help("did you mean " + quoted(*near) + "?");
    if (is_written && fits_everywhere(*near)) {
      diagnostic.fixes.push_back({Applicability::unsafe, {{place, std::string(*near)}}});
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::loses, "leaves the entity out with a message",
     "MARS EntityFactoryManager.cpp:80-89"},
};

}  // namespace

extern constinit const Rule sml5010_misspelt_entity_type{
    .id = "SML5010",
    .name = "misspelt-entity-type",
    .severity = Severity::warning,
    .summary = "The type of an entity is almost one of the known types.",
    .remedy = "Write the type as suggested. A type of a plug-in may have any other name.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules
