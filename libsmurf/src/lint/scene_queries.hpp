// SPDX-License-Identifier: BSD-3-Clause
// Questions that several rules ask of scenes.
#pragma once

#include <functional>
#include <string>

#include "smurf/lint.hpp"

namespace smurf {

/// A use of an entity: as an instance or as an include.
struct Use {
  const LinkedScene& scene;
  const Entity& entity;
  const SceneUse& around;  ///< the use of the scene it is written in
  const Placement& placement;
  const Instance* instance = nullptr;  ///< null for an include

  /// True inside an included scene.
  bool is_nested() const { return around.outer.has_value(); }
  /// Whether MARS gives it the pose, parent and anchor of the enclosing include. MARS compares the
  /// word `world` exactly and treats any other text as a parent.
  bool inherits_in_mars() const { return is_nested() && !has_parent_in_mars(); }
  bool has_parent_in_mars() const {
    return entity.parent.written && entity.parent.value() != "world";
  }
  bool is_member() const {
    return entity.list == EntityList::smurfa && !entity.root.value_or(false);
  }
};

/// Calls `visit` for every entity of every scene file once, however often the file is included.
void for_each_entity(const LinkedScene& scene,
                     const std::function<void(const SceneFile&, const Entity&)>& visit);

/// Calls `visit` for every use of every entity: includes first, then instances.
void for_each_use(const LinkedScene& scene, const std::function<void(const Use&)>& visit);

/// The keys and values of an entity as written.
yaml::View mapping_of(const SceneFile& file, const Entity& entity);

/// The place of the key `type`; without it, that of the file, whose extension decides the type.
Span type_place(const Entity& entity);

/// The value of a top-level key that MARS reads here; none in an assembly, which has no world.
yaml::View world_value(const SceneFile& file, std::string_view key);

/// Whether the user has registered a schema for this entity type.
bool has_schema(const LinkedScene& scene, std::string_view type);

/// A misspelling of `key` in an entity that does not have `key`; null if there is none.
const CustomSection* slip_of(const Entity& entity, std::string_view key);

/// "entity `Eve`", or "this entity".
std::string title(const Entity& entity);

}  // namespace smurf
