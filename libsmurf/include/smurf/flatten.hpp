// SPDX-License-Identifier: BSD-3-Clause
// A scene as a table of models and a table of instances in the world frame.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/flat_shape.hpp"
#include "smurf/limits.hpp"
#include "smurf/linked.hpp"
#include "smurf/old_scene.hpp"
#include "smurf/pose.hpp"
#include "smurf/source.hpp"

namespace smurf {

struct Dialect;
struct SceneReading;

struct ValueMember;

/// Other data of an entity, as far as both YAML and JSON can express them. Numbers keep the value
/// of their text.
struct Value {
  using List = std::vector<Value>;
  using Object = std::vector<ValueMember>;
  std::variant<std::monostate, bool, std::int64_t, double, std::string, List, Object> data;
};
/// A key of an object, with its value.
struct ValueMember {
  std::string key;
  Value value;
};

/// A model that instances share.
struct FlatModel {
  std::string id;    ///< unique; the stem of the file if that is unique
  std::string type;  ///< "smurf" or "urdf"
  std::string file;
  std::string urdf;  ///< equal to `file` for a URDF; empty if there is no URDF
  ModelIndex source{};
  /// Mesh and texture files relative to the output's folder, by the path in the URDF.
  std::map<std::string, std::string, std::less<>> resources;
  /// Textures of annotated materials in the same way, by `diffuseTexture`.
  std::map<std::string, std::string, std::less<>> annotated_textures;
};

/// The thing that an instance is attached to.
struct FlatAttachment {
  Attachment::Kind kind = Attachment::Kind::none;
  std::string instance;   ///< its path; kind link
  std::string link;       ///< kind link
  std::size_t index = 0;  ///< in FlatScene::instances; kind link
};

/// An entity in the world: a model, or a set of shapes.
struct FlatInstance {
  std::string name;  ///< as written
  std::string path;  ///< unique: "outer/inner"
  std::string type;
  std::optional<std::size_t> model;  ///< in FlatScene::models
  std::string file;                  ///< for an entity without model; may be empty
  std::string source_file;           ///< where the entity is written
  std::uint32_t source_line = 1;
  std::optional<Pose> X_WE;  ///< of the root link frame; absent when the scene has errors
  FlatAttachment anchor;
  FlatAttachment parent;  ///< kind none: the world
  /// Positions from the named joint pose set, in the order of the model's joints; rad or m.
  std::vector<std::pair<std::string, double>> joint_positions;
  Value::Object properties;       ///< all other keys
  std::vector<FlatShape> shapes;  ///< of an entity without model
  /// X_WL of every link, in the model's order, if requested.
  std::vector<std::pair<std::string, Pose>> links;
  const Entity* entity = nullptr;  ///< of the linked scene, which must outlive its use
  JointPoseIndex joint_pose{};     ///< in FlatScene::joint_poses
};

/// Settings of the simulation; absent where the scene does not have them.
struct FlatPhysics {
  std::optional<Vector3> gravity;   ///< m/s^2
  std::optional<double> step_size;  ///< s
  std::optional<double> cfm, erp;
};

/// The contents of an old scene except for its shapes.
struct FlatOldScene {
  std::size_t instance = 0;          ///< that names it
  Value::List lights;                ///< in the world frame, wherever the scene is placed
  std::vector<Light> lamps;          ///< the same lights, parsed; their place is that of the entity
  std::vector<std::string> movable;  ///< names of nodes that can move in MARS
  std::vector<std::string> shapeless;  ///< names of nodes whose shape is unknown
  /// Numbers of its other objects, by kind: "joint", "motor", ...; only those above 0.
  std::vector<std::pair<std::string_view, std::size_t>> others;
};

/// The result of flatten(): all included scenes as one, without relative poses.
struct FlatScene {
  std::string scene;  ///< the file
  FlatPhysics physics;
  Value::Object environment;
  Value::List lights;  ///< of scene files, in the world frame
  std::vector<FlatOldScene> old_scenes;
  std::vector<FlatModel> models;
  std::vector<FlatInstance> instances;  ///< depth-first, in file order
  /// The distinct joint poses of the instances, of all joints that do not mimic another joint; in
  /// the first, all joints are at zero.
  std::vector<JointPositions> joint_poses{1};
};

/// The parts of a model that a format writes for each of its instances, besides links, shapes and
/// the text of the URDF.
struct RepeatedParts {
  std::uint64_t bytes = 0;
  std::uint64_t names = 0;  ///< names that get the path of the instance as a prefix
};

/// The parts that a format needs from flatten().
struct FlattenOptions {
  bool links = false;           ///< fill FlatInstance::links
  bool repeats_models = false;  ///< the format writes the model of each instance out
  /// The function of the format; null when it repeats nothing.
  RepeatedParts (*repeated_parts)(const LinkedModel& model) = nullptr;
  /// Folder that all files of the result are relative to.
  std::string output_folder = ".";
  /// Absolute path that relative paths start from; "": the current folder of the process.
  std::string current_folder = {};
  /// The contents of the old scenes; null: entities of old scenes have no shapes.
  const OldScenes* old_scenes = nullptr;
  /// The scene as a dialect reads it, from read_as(). Null means that it is read as documented.
  const SceneReading* reading = nullptr;
};

/// Whether the result of flatten(), and the text that a format makes of it, stay within
/// `limits.scene_bytes`. Reports a finding if not.
bool check_scene_size(const LinkedScene& scene, const SourceMap& sources,
                      const FlattenOptions& options, const Limits& limits, DiagnosticSink& sink);

/// Never fails: entities with errors have no pose. Does not read files.
FlatScene flatten(const LinkedScene& scene, const SourceMap& sources,
                  const FlattenOptions& options);

/// Reports a finding for each entity with poses or sizes that are too large for computations, and
/// returns false if there are any.
bool check_flat_numbers(const FlatScene& flat, const LinkedScene& scene, DiagnosticSink& sink);

/// One transform on the way from the world to an instance.
struct TransformStep {
  std::string what;  ///< "joint `j1` at 0.5 rad"
  Span span;         ///< where it is written; may be empty
  Pose X_step;       ///< relative to the step before
  Pose X_W;          ///< product of all steps so far
};

/// Longer chains are not shown: each parent in a chain of parents adds its joints.
inline constexpr std::size_t kMostSteps = 10'000;

/// The chain of transforms from the world to an instance; empty if the instance has no pose. A
/// longer chain ends after kMostSteps + 1 steps.
std::vector<TransformStep> explain(const LinkedScene& scene, InstanceIndex instance,
                                   const Dialect& dialect);

/// The instance with this path, else the first instance with this name.
std::optional<InstanceIndex> find_instance(const LinkedScene& scene, std::string_view name);

}  // namespace smurf
