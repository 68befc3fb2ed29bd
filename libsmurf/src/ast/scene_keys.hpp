// SPDX-License-Identifier: BSD-3-Clause
// The keys of scenes and assemblies as tables: the scene reader, the JSON schema and the
// suggestions for misspelt keys use the same rows.
#pragma once

#include <span>

#include "ast/keys.hpp"
#include "smurf/scene.hpp"

namespace smurf {

/// The keys of a scene file, with the keys of nested mappings as members: the entities of the three
/// lists, physics, environment. `lights` is the annotation section of that name.
std::span<const KeySpec> scene_keys();

/// Keys of one entity, of `physics` and of `environment`.
std::span<const KeySpec> all_entity_keys();
std::span<const KeySpec> all_physics_keys();
std::span<const KeySpec> environment_keys();

/// The keys with members. The reader distinguishes the forms of `rotation`.
std::span<const Key<Entity>> entity_keys();
std::span<const Key<Physics>> physics_keys();
std::span<const Key<Physics>> ode_keys();

}  // namespace smurf
