// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>

#include "base/files/path.hpp"
#include "base/findings/readers.hpp"
#include "base/text/edits.hpp"
#include "link/scene_link.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5010_misspelt_entity_type_file {
namespace {

/// The type that is meant, for the file of the entity.
std::optional<std::string_view> suggestion(const LinkedScene& scene, const Entity& entity) {
  const auto near = type_meant(scene, entity_type(entity));
  const std::string_view file = entity.file ? std::string_view(*entity.file) : std::string_view();
  const bool is_urdf = path::to_lower(path::extension(file)) == ".urdf";
  return near == "smurf" && is_urdf ? "urdf" : near;
}

void check(const LinkedScene& scene, Findings& findings) {
  for_each_entity(scene, [&](const SceneFile&, const Entity& entity) {
    const std::string type = entity_type(entity);
    const auto near = suggestion(scene, entity);
    if (!near) return;
    const bool is_written = entity.type && !entity.type->empty();
    const Span place = type_place(entity);
    Diagnostic& diagnostic =
        findings.report(place, "the type of " + title(entity) + " is " + quoted(type) +
                                   ", which MARS does not know");
    diagnostic.help("did you mean " + quoted(*near) + "?");
    // A plug-in for a type of Phobos may be missing as well, which is then said.
    const bool is_of_mars = std::find(std::begin(kPhobosTypes), std::end(kPhobosTypes), *near) ==
                            std::end(kPhobosTypes);
    if (is_written && is_of_mars && fits_everywhere(*near)) {
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
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml5010_misspelt_entity_type_file
