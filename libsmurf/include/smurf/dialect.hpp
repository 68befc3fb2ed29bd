// SPDX-License-Identifier: BSD-3-Clause
// The dialects of scenes: programs read different worlds from the same file.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/linked.hpp"

namespace smurf {

/// The place of an entity in the file that a person edits, which is not the scene if that is made
/// of a file of another language.
Span written_at(const Entity& entity);

/// How a reader interprets one entity.
struct EntityReading {
  std::optional<Pose> X_WE;  ///< absent: the reader does not load it
  Attachment parent, anchor;
  JointPoseIndex joint_pose{};  ///< index in SceneReading::joint_poses
  /// How it differs from the documented meaning, or why the entity is not loaded: "reads the angles
  /// as radians". May be empty.
  std::string note;
};

/// How a reader interprets a scene.
struct SceneReading {
  std::vector<EntityReading> entities;  ///< by instance
  /// The distinct joint poses of the entities; in the first, all joints are at zero.
  std::vector<JointPositions> joint_poses{1};
};

/// A way to read scenes.
struct Dialect {
  std::string_view name;  ///< of --dialect
  std::string_view help;
  /// Precondition: the scene was loaded without errors.
  SceneReading (*read)(const LinkedScene& scene) = nullptr;
  /// The pose from the keys of an entity in `use`, as far as it does not depend on other entities.
  Pose (*pose_of)(const LinkedScene& scene, const SceneUse& use, const Entity& entity) = nullptr;
  /// Whether the pose of the include moves the entity.
  bool (*is_moved_by_include)(const Entity& entity) = nullptr;
};

/// All dialects. `spec` comes first: it reads scenes as documented, as `load_scene` does.
std::span<const Dialect* const> dialects();
/// Null if there is no dialect of that name.
const Dialect* find_dialect(std::string_view name);

/// The poses, anchors and joint positions that a reader gives the instances of a scene. Reports
/// those that it does not load.
SceneReading read_as(const Dialect& dialect, const LinkedScene& scene, DiagnosticSink& sink);

/// True when two poses are equal within 1e-9 m and 1e-9 rad.
bool is_same_pose(const std::optional<Pose>& a, const std::optional<Pose>& b);

}  // namespace smurf
