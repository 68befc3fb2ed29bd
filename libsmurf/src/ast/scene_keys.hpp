// SPDX-License-Identifier: BSD-3-Clause
// The keys of scenes and assemblies as tables: the scene reader, the JSON schema and the
// suggestions for misspelt keys are made from the same rows.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "ast/keys.hpp"
#include "smurf/scene.hpp"

namespace smurf {

/// Keys of one entity. `rotation` has no member: its forms are told apart by the scene reader.
std::span<const Key<Entity>> entity_keys();

/// Keys of `physics` and of `physics.ode`; both fill the same struct.
std::span<const Key<Physics>> physics_keys();
std::span<const Key<Physics>> ode_keys();

/// One kind of mapping in a scene file.
struct SceneTable {
  /// Where it stands: "" is the file itself, "*" one entry of each entity list, otherwise the keys
  /// that lead to it ("environment/fog").
  std::string_view path;
  std::string_view what; ///< "entity", "fog"; for messages
  std::string_view doc;  ///< one sentence, for the schema
  std::vector<const KeySpec*> (*keys)() = nullptr;
};

/// All of them, outer mappings before inner ones. `lights` is the annotation section of that name.
std::span<const SceneTable> scene_tables();

} // namespace smurf
