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

struct ValueMember;

/// Other data of an entity, as far as both YAML and JSON can express it. Numbers keep the value of
/// their text.
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
  std::string id;    ///< unique; the file's stem where that is
  std::string type;  ///< "smurf" or "urdf"
  std::string file;
  std::string urdf;  ///< the same as `file` for a URDF; empty when there is none
  ModelIndex source{};
  /// Mesh and texture files relative to the output's folder, by what the URDF writes.
  std::map<std::string, std::string, std::less<>> resources;
  /// Same, by the `diffuseTexture` of a material of the annotations.
  std::map<std::string, std::string, std::less<>> annotated_textures;
};

/// The thing that an instance is attached to.
struct FlatAttachment {
  Attachment::Kind kind = Attachment::Kind::none;
  std::string instance;  ///< its path; kind link
  std::string link;      ///< kind link
};

/// An entity in the world: a model, or shapes of its own.
struct FlatInstance {
  std::string name;  ///< as written
  std::string path;  ///< unique: "outer/inner"
  std::string type;
  std::optional<std::size_t> model;  ///< in FlatScene::models
  std::string file;                  ///< of an entity without model; may be empty
  std::string source_file;           ///< where the entity is written
  std::uint32_t source_line = 1;
  std::optional<Pose> X_WE;  ///< of the root link frame; absent when the scene has errors
  FlatAttachment anchor;
  FlatAttachment parent;  ///< kind none: the world
  /// Positions from the named joint pose set, in the order of the model's joints; rad or m.
  std::vector<std::pair<std::string, double>> joint_positions;
  Value::Object properties;       ///< all other keys
  std::vector<FlatShape> shapes;  ///< of an entity without model
  /// X_WL of every link, in the model's order, when asked for.
  std::vector<std::pair<std::string, Pose>> links;
};

/// Settings of the simulation; absent where the scene does not have them.
struct FlatPhysics {
  std::optional<Vector3> gravity;   ///< m/s^2
  std::optional<double> step_size;  ///< s
  std::optional<double> cfm, erp;
};

/// The contents of an old scene other than shapes.
struct FlatOldScene {
  std::size_t instance = 0;            ///< that names it
  Value::List lights;                  ///< in the world frame, wherever the scene is placed
  std::vector<Light> lamps;            ///< the same, read; their places are that of the entity
  std::vector<std::string> movable;    ///< names of nodes that MARS lets move
  std::vector<std::string> shapeless;  ///< names of nodes without a shape that is known here
  /// Numbers of other things in it, by their names: "joint", "motor", ...; only those above 0.
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
};

/// What a format writes of a model in each of its instances, besides links, shapes and the text of
/// the URDF.
struct RepeatedParts {
  std::uint64_t bytes = 0;
  std::uint64_t names = 0;  ///< that the path of the instance is written before
};

/// The parts that a format needs from flatten().
struct FlattenOptions {
  bool links = false;           ///< fill FlatInstance::links
  bool repeats_models = false;  ///< the format writes the model of each instance out
  /// The function of the format; null when it repeats nothing.
  RepeatedParts (*repeated_parts)(const LinkedModel& model) = nullptr;
  /// Folder that all files of the result are relative to.
  std::string output_folder = ".";
  /// Absolute path that relative paths start from.
  std::string current_folder = "/";
  /// The contents of the old scenes; null: their entities have no shapes.
  const OldScenes* old_scenes = nullptr;
};

/// False, and a finding, when the result of flatten(), or what a format writes of it, would be
/// larger than `limits.scene_bytes`.
bool check_scene_size(const LinkedScene& scene, const SourceMap& sources,
                      const FlattenOptions& options, const Limits& limits, DiagnosticSink& sink);

/// Never fails: entities with errors have no pose. Reads no files.
FlatScene flatten(const LinkedScene& scene, const SourceMap& sources,
                  const FlattenOptions& options);

/// False, and a finding for each entity concerned, when poses or sizes are too large for the
/// formats to compute with.
bool check_flat_numbers(const FlatScene& flat, const LinkedScene& scene, DiagnosticSink& sink);

/// One transform on the way from the world to an instance.
struct TransformStep {
  std::string what;  ///< "joint `j1` at 0.5 rad"
  Span span;         ///< where it is written; may be empty
  Pose X_step;       ///< relative to the step before
  Pose X_W;          ///< all steps so far
};

/// Longer chains are not shown: each parent in a chain of parents adds its joints.
inline constexpr std::size_t kMostSteps = 10'000;

/// The chain of transforms of an instance, from the world on; empty when the instance has no pose.
/// One that is too long ends after kMostSteps + 1.
/// `scene` is as loaded, or as apply_dialect() left it with this dialect.
std::vector<TransformStep> explain(const LinkedScene& scene, InstanceIndex instance,
                                   const Dialect& dialect);

/// An instance by its path, else the first by its name.
std::optional<InstanceIndex> find_instance(const LinkedScene& scene, std::string_view name);

}  // namespace smurf
