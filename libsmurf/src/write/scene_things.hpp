// SPDX-License-Identifier: BSD-3-Clause
// The one table of what a model or a scene can hold and what becomes of it in each format. The
// warnings of the writers, --strict, --loss-report and docs/scene-formats.md come from it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/write_scene.hpp"

namespace smurf {

/// Formats that do not name the models of a scene, but say themselves what is in them. JSON and
/// SMURFS name the models and keep the rest; TSV, dot and SVG show where things stand.
enum class SceneColumn : std::uint8_t { sdf, sdf16, mjcf, urdf, dmd, html, gltf, usda };
inline constexpr std::size_t kSceneColumns = 8;
inline std::size_t to_size(SceneColumn column) { return static_cast<std::size_t>(column); }

/// Where a thing is written, which decides how it is reported.
enum class ThingOf : std::uint8_t {
  urdf,        ///< a format that refers to the URDF keeps it
  annotation,  ///< those of a model are counted in one finding
  scene
};

struct FoundThing {
  Span span;
  std::string name;
};

/// What a format does with it begins its cell.
enum class Fate : std::uint8_t {
  kept,
  partly,  ///< kept, except for the things found
  changed,
  lost,
  added,  ///< the format needs a value that nobody wrote: no loss
  shown   ///< a preview shows shapes only; reported once per model
};

/// Settings of scene files, each of which is reported at its place.
enum class WorldSetting : std::uint8_t { none, gravity, step_size, solver, environment, lights };

/// Titles of what the writers note themselves.
inline constexpr std::string_view kInventedMasses = "masses of moving links that have none";
inline constexpr std::string_view kEmptyShapes = "shapes with a size of 0";
inline constexpr std::string_view kRefusedInertias = "inertias that simulators refuse";

struct SceneThing {
  std::string_view title;  ///< plural: "effort limits"; of an annotation singular: "motor"
  ThingOf of = ThingOf::urdf;
  /// Finds the things in a model, or in a scene, that are not kept. Called where the cell is not
  /// "kept". When both are null, the writers report the loss themselves.
  std::vector<FoundThing> (*in_model)(const LinkedModel& model, SceneColumn column) = nullptr;
  std::vector<FoundThing> (*in_scene)(const SceneExport& scene, SceneColumn column) = nullptr;
  WorldSetting setting = WorldSetting::none;
  /// By column: "kept", or "kept: how", "partly: what", "changed: how", "lost: why", "added: what",
  /// "shown".
  std::array<std::string_view, kSceneColumns> cells{};
};

std::span<const SceneThing> scene_things();

/// By the first word of a cell.
Fate fate_of(std::string_view cell);
/// What follows the colon; "" when there is none.
std::string_view reason_of(std::string_view cell);

}  // namespace smurf
