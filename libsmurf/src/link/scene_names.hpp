// SPDX-License-Identifier: BSD-3-Clause
// Finds the entity that a name in a scene means.
#pragma once

#include <map>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "smurf/linked.hpp"

namespace smurf {

/// An entity is an instance, or the include of a scene.
using EntityIndex = std::variant<InstanceIndex, UseIndex>;

/// Names are looked up in the scene file that uses them, then in the enclosing scenes, then
/// anywhere, because MARS has one table for all scenes. Of equal names in one scene, the first is
/// used. Views point into the entities of the scene files.
class SceneNames {
 public:
  void add_use() { scopes_.emplace_back(); }
  void add(UseIndex scope, std::string_view name, EntityIndex entity);

  std::optional<EntityIndex> find(UseIndex scope, std::string_view name,
                                  const LinkedScene& scene) const;
  /// A scene file could not be read, so there may be more names.
  void mark_incomplete() { is_complete_ = false; }
  bool is_complete() const { return is_complete_; }
  /// All known names, for suggestions.
  const std::vector<std::string_view>& names() const { return names_; }

 private:
  std::vector<std::map<std::string_view, EntityIndex>> scopes_;  ///< by use
  std::map<std::string_view, EntityIndex> anywhere_;
  std::vector<std::string_view> names_;  ///< unique, in order
  bool is_complete_ = true;
};

}  // namespace smurf
