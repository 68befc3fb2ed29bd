// SPDX-License-Identifier: BSD-3-Clause
// Where a model or a scene has the things of the table (scene_things.hpp) that a format does not
// keep.
#pragma once

#include "write/scene_things.hpp"

namespace smurf::things {

using Found = std::vector<FoundThing>;

// Of a URDF.
Found masses(const LinkedModel& model, SceneColumn);
Found collision_shapes(const LinkedModel& model, SceneColumn);
Found movable_joints(const LinkedModel& model, SceneColumn);
/// In MJCF those that MuJoCo does not read.
Found textures(const LinkedModel& model, SceneColumn column);
/// In MJCF those of joints that nothing drives.
Found efforts(const LinkedModel& model, SceneColumn column);
Found velocities(const LinkedModel& model, SceneColumn);
Found joint_frictions(const LinkedModel& model, SceneColumn);
Found safety_controllers(const LinkedModel& model, SceneColumn);
Found calibrations(const LinkedModel& model, SceneColumn);
Found newer_limits(const LinkedModel& model, SceneColumn);
/// In MJCF and USD those that drive no joint there.
Found transmissions(const LinkedModel& model, SceneColumn column);
Found ros2_controls(const LinkedModel& model, SceneColumn column);
/// In SDF those that Gazebo does not convert, in MJCF all but sensors.
Found gazebo_elements(const LinkedModel& model, SceneColumn column);
Found other_extensions(const LinkedModel& model, SceneColumn);

// Of annotations.
/// All entries of a section.
template <auto section>
Found entries(const LinkedModel& model, SceneColumn) {
  Found found;
  for (const Annotation& entry : model.annotations.*section) {
    found.push_back({entry.span, entry.name.value_or({})});
  }
  return found;
}
/// In MJCF and USD those that move no joint.
Found motors(const LinkedModel& model, SceneColumn column);
/// Keys that an actuator of MuJoCo, or a drive of USD, does not have.
Found motor_keys(const LinkedModel& model, SceneColumn column);
/// In SDF and MJCF those without a counterpart there.
Found sensors(const LinkedModel& model, SceneColumn column);
/// Keys that a sensor of Gazebo, or of MuJoCo, does not have.
Found sensor_keys(const LinkedModel& model, SceneColumn column);
/// In SDF, MJCF and USD keys, elsewhere entries.
Found collision_settings(const LinkedModel& model, SceneColumn column);
Found other_sections(const LinkedModel& model, SceneColumn);

// Of scenes.
Found no_gravity(const SceneExport& scene, SceneColumn);
Found no_step(const SceneExport& scene, SceneColumn);
Found ambient_lights(const SceneExport& scene, SceneColumn);
Found light_details(const SceneExport& scene, SceneColumn);
/// Of joints that do not start at zero.
Found start_positions(const SceneExport& scene, SceneColumn);
/// Keys of entities with a shape of their own that the format ignores.
Found entity_keys(const SceneExport& scene, SceneColumn column);

}  // namespace smurf::things
