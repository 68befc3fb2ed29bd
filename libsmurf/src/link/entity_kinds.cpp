// SPDX-License-Identifier: BSD-3-Clause
// What the types of entities mean.
#include "ast/known_words.hpp"
#include "base/files/path.hpp"
#include "base/ranges.hpp"
#include "base/text/suggest.hpp"
#include "link/scene_link.hpp"
#include "smurf/archive_files.hpp"
#include "smurf/user_schemas.hpp"

namespace smurf {

namespace {

/// A new type is a row here and a word of kEntityTypes.
const std::vector<ModelType>& model_types() {
  static const std::vector<ModelType> types{{"smurf", {".smurf"}},
                                            {"particle", {".smurf"}},
                                            {"urdf", {".urdf"}},
                                            {"sdf", {".sdf", ".world"}, false},
                                            {"mjcf", {".xml", ".mjcf"}, false}};
  return types;
}

std::string packed_type(std::string_view type) {
  std::string lower = path::to_lower(type);
  return is_archive_type(lower) ? lower.substr(1) : lower;
}

}  // namespace

const ModelType* model_type(std::string_view type) {
  const std::string name = packed_type(type);
  for (const ModelType& one : model_types()) {
    if (one.name == name) return &one;
  }
  return nullptr;
}

std::string_view type_of_extension(std::string_view extension) {
  for (const ModelType& one : model_types()) {
    if (ranges::contains(one.extensions, extension)) return one.name;
  }
  return {};
}

EntityKind kind_of(std::string_view type) {
  if (model_type(type) != nullptr) return EntityKind::model;
  const std::string packed = packed_type(type);
  if (packed == "smurfs" || packed == "smurfa") return EntityKind::scene;
  return EntityKind::other;
}

std::optional<std::string_view> type_meant(const LinkedScene& scene, std::string_view type) {
  std::vector<std::string_view> known(std::begin(kEntityTypes), std::end(kEntityTypes));
  known.insert(known.end(), std::begin(kPhobosTypes), std::end(kPhobosTypes));
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
