// SPDX-License-Identifier: BSD-3-Clause
// Finds the rows of the table (loss_table.hpp) that a model or scene uses and a format loses.
#pragma once

#include "write/losses/loss_table.hpp"

namespace smurf::things {

using Found = std::vector<FoundThing>;
void append(Found& all, Found some);
/// The `name` of an element, or its tag.
inline std::string name_or_tag(xml::View element) {
  const xml::Attribute* name = element.attribute("name");
  return std::string(name != nullptr ? name->value() : element.name());
}

// In a URDF.
Found masses(const LinkedModel& model, SceneColumn);
Found collision_shapes(const LinkedModel& model, SceneColumn);
/// The collision meshes whose convex hull has a much larger volume than they have, with the ratio.
Found concave_meshes(const LinkedModel& model, SceneColumn);
Found movable_joints(const LinkedModel& model, SceneColumn);
/// Joints to a link that already has a parent joint.
Found closing_joints(const LinkedModel& model, SceneColumn);
/// Joints without both links, and links that the first root does not reach.
Found unreached_parts(const LinkedModel& model, SceneColumn);
/// MJCF: only textures that MuJoCo does not read. HTML: none, because the writer reports them.
Found textures(const LinkedModel& model, SceneColumn column);
/// MJCF: only efforts of joints without a motor.
Found efforts(const LinkedModel& model, SceneColumn column, const MotorOptions& options);
Found velocities(const LinkedModel& model, SceneColumn);
Found joint_frictions(const LinkedModel& model, SceneColumn);
Found safety_controllers(const LinkedModel& model, SceneColumn);
Found calibrations(const LinkedModel& model, SceneColumn);
Found newer_limits(const LinkedModel& model, SceneColumn);
Found chosen_gains(const LinkedModel& model, SceneColumn column, const MotorOptions& options);
/// MJCF and USD: only transmissions without a joint. Drake directives: only those of ros2_control
/// whose joint has no transmission.
Found transmissions(const LinkedModel& model, SceneColumn column, const MotorOptions& options);
Found ros2_controls(const LinkedModel& model, SceneColumn column, const MotorOptions& options);
/// SDF: only elements that Gazebo does not convert. MJCF: all elements except sensors.
Found gazebo_elements(const LinkedModel& model, SceneColumn column, const MotorOptions& options);
/// Sensors that need plug-ins of the world in Gazebo.
Found sensor_systems(const LinkedModel& model, SceneColumn);
Found other_extensions(const LinkedModel& model, SceneColumn);
Found other_attributes(const LinkedModel& model, SceneColumn);

// In annotations.
/// Keys of an entry of a section other than those that the format expresses.
Found other_keys(const LinkedModel& model, const Annotation& entry,
                 const std::vector<std::string_view>& said);
/// All entries of a section.
template <auto section>
Found entries(const LinkedModel& model, SceneColumn) {
  Found found;
  for (const Annotation& entry : model.annotations.*section) {
    found.push_back({entry.span, entry.name.value_or({})});
  }
  return found;
}
/// Only entries that say more than that a tensor is meant.
Found link_settings(const LinkedModel& model, SceneColumn);
/// MJCF, USD and SDF: only motors that move no joint.
Found motors(const LinkedModel& model, SceneColumn column, const MotorOptions& options);
/// Keys that actuators of MuJoCo, or drives of USD, do not have.
Found motor_keys(const LinkedModel& model, SceneColumn column);
/// SDF and MJCF: only sensors that the format does not have.
Found sensors(const LinkedModel& model, SceneColumn column, const MotorOptions& options);
/// Keys that sensors of Gazebo, or of MuJoCo, do not have.
Found sensor_keys(const LinkedModel& model, SceneColumn column, const MotorOptions& options);
/// HTML: only materials that the URDF does not have.
Found materials(const LinkedModel& model, SceneColumn column);
/// Keys of materials that the page does not show.
Found material_keys(const LinkedModel& model, SceneColumn);
/// HTML: the lost keys. Other formats: the entries.
Found visual_settings(const LinkedModel& model, SceneColumn column);
/// SDF, MJCF and USD: the lost keys. Other formats: the entries.
Found collision_settings(const LinkedModel& model, SceneColumn column);
Found other_sections(const LinkedModel& model, SceneColumn);

// In scenes.
/// Models within which nothing touches, since nobody chose what does.
Found own_collisions(const SceneExport& scene, SceneColumn);
/// Links and joints of models with another name in the SDF.
Found reserved_names(const SceneExport& scene, SceneColumn column);
/// Pairs of links that touch in the result, and that the SRDF or the model disables.
Found disabled_pairs(const SceneExport& scene, SceneColumn column);
Found no_gravity(const SceneExport& scene, SceneColumn);
Found no_step(const SceneExport& scene, SceneColumn);
Found ambient_lights(const SceneExport& scene, SceneColumn);
Found light_details(const SceneExport& scene, SceneColumn);
/// Start positions of joints that do not start at zero.
Found start_positions(const SceneExport& scene, SceneColumn);
/// Robots that no anchor holds.
Found free_robots(const SceneExport& scene, SceneColumn);
/// Entities with another name in the result.
Found changed_names(const SceneExport& scene, SceneColumn column);
/// Entities without an anchor whose root is fixed to the world because of its name.
Found world_roots(const SceneExport& scene, SceneColumn);
/// Keys of entities with shapes that the format ignores.
Found entity_keys(const SceneExport& scene, SceneColumn column);

}  // namespace smurf::things
