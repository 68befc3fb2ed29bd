// SPDX-License-Identifier: BSD-3-Clause
// yaml::Document -> Scene.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "smurf/diagnostic.hpp"
#include "smurf/scene.hpp"

namespace smurf {

/// Reads a scene or assembly, up to `most_entities`. None if the root is not a mapping.
std::optional<Scene> read_scene(const yaml::Document& document, DiagnosticSink& sink,
                                std::size_t most_entities = SIZE_MAX);

/// The keys of an entity.
Entity read_entity(yaml::View mapping, EntityList list, DiagnosticSink& sink);

}  // namespace smurf
