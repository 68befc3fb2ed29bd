// SPDX-License-Identifier: BSD-3-Clause
// What the types of entities mean.
#include "ast/known_words.hpp"
#include "base/files/path.hpp"
#include "base/text/suggest.hpp"
#include "link/scene_link.hpp"
#include "smurf/archive_files.hpp"
#include "smurf/user_schemas.hpp"

namespace smurf {

EntityKind kind_of(std::string_view type) {
  const std::string lower = path::to_lower(type);
  const std::string_view packed =
      is_archive_type(lower) ? std::string_view(lower).substr(1) : lower;
  if (packed == "smurf" || packed == "particle" || packed == "urdf") return EntityKind::model;
  if (packed == "smurfs" || packed == "smurfa") return EntityKind::scene;
  return EntityKind::other;
}

std::optional<std::string_view> type_meant(const LinkedScene& scene, std::string_view type) {
  std::vector<std::string_view> known(std::begin(kEntityTypes), std::end(kEntityTypes));
  if (is_archive_type(type)) return std::nullopt;
  if (scene.schemas != nullptr) {
    if (scene.schemas->has_entity_type(type)) return std::nullopt;
    const std::vector<std::string_view> own = scene.schemas->entity_types();
    known.insert(known.end(), own.begin(), own.end());
  }
  // Words of other formats, which no edit turns into a type of MARS.
  const std::string lower = path::to_lower(type);
  if (lower == "robot" || lower == "model") return "smurf";
  return nearest(type, known);
}

bool is_old_scene(std::string_view type) {
  return type == "scn" || type == "scene" || type == "yml";
}

}  // namespace smurf
