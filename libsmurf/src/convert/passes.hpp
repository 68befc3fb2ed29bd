// SPDX-License-Identifier: BSD-3-Clause
// The steps of an export. Each step makes byte edits in the text that the previous step wrote; all
// other bytes stay the same.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "convert/xml_edits.hpp"
#include "smurf/convert.hpp"

namespace smurf::passes {

/// Annotations into the URDF; reports SML8003.
void apply_annotations(const LinkedModel& model, const UrdfExport& options, DiagnosticSink& sink,
                       XmlEdits& edits);
/// Motors whose joints are not driven yet, as an extension that does; see driven_joints().
void add_actuation(const LinkedModel& model, Actuation actuation, XmlEdits& edits);
/// What is commanded to a motor: "position", "velocity" or "effort".
std::string_view interface_of(const Motor& motor);
/// Sensors as <gazebo><sensor>, those that Gazebo has and the URDF does not name yet.
void add_gazebo_sensors(const LinkedModel& model, XmlEdits& edits);
/// <compiler strippath="false">, without which MuJoCo before 3.7 looks for meshes beside the URDF.
/// Paths that were rewritten are no longer those that the author's settings are about.
void add_mujoco_settings(const LinkedModel& model, bool has_new_paths, XmlEdits& edits);
/// Gazebo's type of a sensor; "" when it has none.
std::string_view gazebo_type(const Sensor& sensor);
/// Gazebo's <sensor> of a sensor that it has a type for. `document` is the one that it stands in.
std::string gazebo_sensor(const yaml::Document& document, const Sensor& sensor,
                          std::string_view name);
/// The link or joint that Gazebo's sensor stands on; "" when the annotation names none.
std::string gazebo_carrier(const LinkedModel& model, const Sensor& sensor);
/// add_gazebo_sensors() takes over what the key of such a sensor says.
bool gazebo_says(const Sensor& sensor, std::string_view key);
/// Names of <element name="..."> below the robot's extensions, or those of one name.
std::set<std::string_view> names_in_extensions(const LinkedModel& model, std::string_view element,
                                               std::string_view extension = {});
/// Joints that the URDF drives already: for ros2_control, which does not read the transmissions of
/// ROS 1, those of its own.
std::set<std::string_view> driven_joints(const LinkedModel& model, Actuation actuation);
/// Transmissions of ROS 1 of which ros2_control drives all joints, and that go.
std::vector<xml::View> replaced_transmissions(const LinkedModel& model, Actuation actuation);
/// Mesh and texture paths, as options.mesh_uri wants them.
void rewrite_paths(const LinkedModel& model, const UrdfExport& options, XmlEdits& edits);

void strip_comments(const LinkedModel& model, XmlEdits& edits);
void strip_extensions(const LinkedModel& model, XmlEdits& edits);
struct CollapsedLink {
  std::string name;
  std::string carrier;  ///< that it is part of now
};
/// Links on fixed joints become part of the link that carries them, unless they or their joints are
/// to be kept, or an extension means the link itself (link_references.hpp).
std::vector<CollapsedLink> collapse_fixed(const LinkedModel& model,
                                          const std::vector<std::string>& keep, XmlEdits& edits);
/// A link of this name is the world: DART, Gazebo and MuJoCo fix whatever is attached to it.
inline bool is_world(std::string_view link) { return link == "world"; }
/// Names of links, joints, materials and transmissions, and all references to them; not the world.
void add_prefix(const LinkedModel& model, const std::string& prefix, XmlEdits& edits);
/// Rewrites what only later versions of URDF have for `version`, where that is possible.
void set_version(const LinkedModel& model, const std::string& version, XmlEdits& edits);
/// The attributes of limits that are new in URDF 1.2; nothing before says the same.
std::vector<const xml::Attribute*> newer_limits(const LinkedModel& model, std::string_view version);
/// A joint from a link `world` to the root.
void add_base(const LinkedModel& model, BaseJoint base, XmlEdits& edits);

/// Elements that URDF does not define, of the robot, its links and joints.
std::vector<xml::View> extension_elements(const urdf::Robot& robot);

}  // namespace smurf::passes

namespace smurf {

/// The whole document in canonical form: links and joints in the order of the tree, attributes in a
/// fixed order, the shortest numbers.
std::string canonical_urdf(const LinkedModel& model, std::string_view text);

}  // namespace smurf
