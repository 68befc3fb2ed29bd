// SPDX-License-Identifier: BSD-3-Clause
// The table of the contents of models and scenes and their fate in each format. The warnings of the
// writers, --fail-on-loss, --loss-report and docs/scene-formats.md are made from it.
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

/// Formats that write models out. JSON and SMURFS name the models and keep the rest; TSV, dot and
/// SVG show only positions.
enum class SceneColumn : std::uint8_t { sdf, sdf16, mjcf, urdf, dmd, html, gltf, usda };
inline constexpr std::size_t kSceneColumns = 8;
inline std::size_t to_size(SceneColumn column) { return static_cast<std::size_t>(column); }

/// The place of a thing in the files, which decides how its loss is reported.
enum class ThingOf : std::uint8_t {
  urdf,        ///< a format that refers to the URDF keeps it
  annotation,  ///< those of a model are counted in one finding
  setting,     ///< the same for keys of annotations that are kept
  scene
};

struct FoundThing {
  Span span;
  std::string name;
};

/// What a format does with a thing.
enum class Fate : std::uint8_t {
  kept,
  partly,  ///< kept, except for the things found
  changed,
  lost,
  added,  ///< the format needs a value that is not in the source: not a loss
  shown   ///< a preview shows shapes only; reported once per model
};

struct Cell {
  Fate fate = Fate::kept;
  std::string_view reason;  ///< how, why, or which part is kept; "" if there is no more to say
};

/// Settings of scene files; each loss is reported at its place.
enum class WorldSetting : std::uint8_t {
  none,
  gravity,
  step_size,
  solver,
  environment,
  plugins,
  lights
};

/// Titles of things that the writers report themselves.
inline constexpr std::string_view kInventedMasses = "masses of moving links that have none";
inline constexpr std::string_view kEmptyShapes = "shapes with a size of 0";
inline constexpr std::string_view kAbsentInertias = "moments of inertia that are not written";
inline constexpr std::string_view kUselessInertias = "moments of inertia of 0 and placeholders";
inline constexpr std::string_view kBoundedGains = "gains of controllers";
inline constexpr std::string_view kRefusedInertias = "inertias that simulators refuse";
inline constexpr std::string_view kColorsOfMeshes = "colours of parts of mesh files";
inline constexpr std::string_view kLostContacts = "collisions of contact sensors on several links";
inline constexpr std::string_view kOddHeights = "heightmaps that are not square";
inline constexpr std::string_view kUnsureHeights = "heightmaps in colour or out of reach";

struct SceneThing {
  std::string_view title;  ///< plural: "effort limits"; of an annotation singular: "motor"
  ThingOf of = ThingOf::urdf;
  /// Finds the things in a model, or in a scene, that are not kept. Called if the cell is not
  /// `kept`. If all are null, the writers report the loss themselves.
  std::vector<FoundThing> (*in_model)(const LinkedModel& model, SceneColumn column) = nullptr;
  /// The same for what depends on the motors that the caller asks for.
  std::vector<FoundThing> (*in_motors)(const LinkedModel& model, SceneColumn column,
                                       const MotorOptions& motors) = nullptr;
  std::vector<FoundThing> (*in_scene)(const SceneExport& scene, SceneColumn column) = nullptr;
  WorldSetting setting = WorldSetting::none;
  std::array<Cell, kSceneColumns> cells{};  ///< by column
};

std::span<const SceneThing> scene_things();

}  // namespace smurf
