// SPDX-License-Identifier: BSD-3-Clause
// Functions that the dialects share.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "link/scene_link.hpp"
#include "smurf/dialect.hpp"

namespace smurf {

/// The joint that a reader finds for an entry of a joint pose set; none if it finds none.
using JointOfEntry = std::function<std::optional<std::string>(const std::string& entry)>;
/// The joint of the motor of that name (MARS SimEntity.cpp:505-511).
JointOfEntry joint_of_motor(const LinkedModel& model);

/// Joint positions of the selected sets of an entity: its own sets and those of its model whose
/// name ("" if absent) is that of `pose`. Later entries override earlier ones.
JointPositions positions_of_pose(const Entity& entity, const LinkedModel& model,
                                 std::string_view pose, const JointOfEntry& joint_of_entry);

/// The joint poses of a reading. Entities that select the same sets share one.
class JointPoseTable {
 public:
  explicit JointPoseTable(std::vector<JointPositions>& poses) : poses_(poses) {}

  /// The result of `read` for an entity that selects `pose`; computed once.
  JointPoseIndex of(const Entity& entity, const LinkedModel& model, std::string_view pose,
                    const std::function<JointPositions()>& read);

 private:
  using Key = std::tuple<const LinkedModel*, const Entity*, std::string>;
  bool has_own(const Entity& entity, std::string_view pose);

  std::vector<JointPositions>& poses_;
  std::map<Key, JointPoseIndex> known_;  ///< null for an entity without its own sets
  std::map<std::pair<const Entity*, std::string>, bool> has_own_;
};

/// X_EL of a link; none if the model has no such link, or if the root does not reach it.
std::optional<Pose> link_frame(const LinkedScene& scene, const SceneReading& reading,
                               InstanceIndex instance, std::string_view link, LinkFrames& frames);

/// The documented pose, which Phobos composes in the same way.
Pose documented_pose(const LinkedScene& scene, const SceneUse& use, const Entity& entity);
bool has_no_parent_link(const Entity& entity);

/// Adds to a note: "one thing, another".
void add_note(std::string& note, std::string_view text);

}  // namespace smurf
