// SPDX-License-Identifier: BSD-3-Clause
// The steps of linking a scene, in the order they run.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "link/scene_names.hpp"
#include "smurf/load.hpp"

namespace smurf {

/// The kind of an entity, by its type.
enum class EntityKind : std::uint8_t {
  model,  ///< those with a ModelType
  scene,  ///< smurfs, smurfa, and zsmurfs, zsmurfa: included in place
  other   ///< old scenes, primitives, types of plug-ins: kept without expansion
};
/// A type of entities that are models.
struct ModelType {
  std::string_view name;
  std::vector<std::string_view> extensions;  ///< of its files: ".sdf"
  bool is_of_mars = true;                    ///< whether MARS loads it
};
/// Null for other types. That of an archive is the type of the model in it.
const ModelType* model_type(std::string_view type);
/// The type whose usual files have this extension, ".sdf"; "" if there is none.
std::string_view type_of_extension(std::string_view extension);
/// Type as written, else the extension of the file without the dot.
std::string entity_type(const Entity& entity);
EntityKind kind_of(std::string_view type);
/// Types that Phobos writes, and for which MARS needs a plug-in.
inline constexpr std::string_view kPhobosTypes[] = {"light", "heightmap", "mesh", "generic"};
/// The known type that a misspelt type probably means; none for other types, as of plug-ins.
std::optional<std::string_view> type_meant(const LinkedScene& scene, std::string_view type);
/// scn, scene and yml: scenes of MARS before SMURF, which have separate loaders.
bool is_old_scene(std::string_view type);

/// 1. Reads the scene, its included scenes and their models; fills all of `scene` except
/// placements. False if the scene itself could not be read.
bool expand_scene(const std::string& path, LoadContext& context, LinkedScene& scene,
                  SceneNames& names);

/// Reports files that `environment` names and MARS will probably not find.
void check_world_files(const SceneFile& scene, LoadContext& context);

/// 2. Fills the placements of uses and instances: parents, anchors, poses relative to the parent.
void resolve_references(LoadContext& context, SceneNames& names, LinkedScene& scene);

/// The anchor of a model if its scene sets none: the world if the annotation of its root link has
/// the Phobos property `anchor: world`.
Attachment anchor_of_root(const LinkedModel& model);

/// 3. Fills the joint positions of instances from their named joint pose sets.
void resolve_joint_poses(LoadContext& context, LinkedScene& scene);

/// 4. Fills X_WE, independently of the order of entities.
void compose_world_poses(LoadContext& context, LinkedScene& scene);

/// The key that sets the parent of an instance: its own, or that of an enclosing include.
Span parent_place(const LinkedScene& scene, const Instance& instance);

/// Forward kinematics, computed once per model and joint pose as long as memory is available.
class LinkFrames {
 public:
  /// Poses X_EL by LinkIndex; empty if the instance has no model. Valid until the next call.
  const std::vector<std::optional<Pose>>& of(const LinkedScene& scene, const Instance& instance);
  /// The same for another joint pose in `poses`. All calls must pass the same table.
  const std::vector<std::optional<Pose>>& of(const LinkedScene& scene, ModelIndex model,
                                             JointPoseIndex pose,
                                             const std::vector<JointPositions>& poses);
  /// The cost of all computations so far.
  std::uint64_t steps() const { return steps_; }

 private:
  std::map<std::pair<ModelIndex, JointPoseIndex>, std::vector<std::optional<Pose>>> frames_;
  std::size_t kept_ = 0;  ///< poses in frames_
  std::uint64_t steps_ = 0;
  std::vector<std::optional<Pose>> none_;
};

}  // namespace smurf
