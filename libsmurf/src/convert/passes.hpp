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

/// Applies annotations to the URDF; reports SML8003.
void apply_annotations(const LinkedModel& model, const UrdfExport& options, DiagnosticSink& sink,
                       XmlEdits& edits);
/// Writes motors as an extension, for joints that are not driven yet; see driven_joints().
void add_actuation(const LinkedModel& model, Actuation actuation, XmlEdits& edits);
/// The commanded quantity of a motor: "position", "velocity" or "effort".
std::string_view interface_of(const Motor& motor);
/// Writes sensors as <gazebo><sensor> if Gazebo has the type and the URDF does not have the sensor.
void add_gazebo_sensors(const LinkedModel& model, XmlEdits& edits);
/// Writes <compiler strippath="false">, without which MuJoCo before 3.7 looks for meshes beside the
/// URDF. After paths are rewritten, the author's settings no longer apply to them.
void add_mujoco_settings(const LinkedModel& model, bool has_new_paths, XmlEdits& edits);
/// Gazebo's type of a sensor; "" if there is none.
std::string_view gazebo_type(const Sensor& sensor);
/// Gazebo's <sensor> for an annotation with a known type. `document` contains the annotation.
std::string gazebo_sensor(const yaml::Document& document, const Sensor& sensor,
                          std::string_view name);
/// The link or joint that carries Gazebo's sensor; "" if the annotation names none.
std::string gazebo_carrier(const LinkedModel& model, const Sensor& sensor);
/// Whether add_gazebo_sensors() writes the value of the key.
bool gazebo_says(const Sensor& sensor, std::string_view key);
/// Names of <element name="..."> in the robot's extensions, or in those of one name.
std::set<std::string_view> names_in_extensions(const LinkedModel& model, std::string_view element,
                                               std::string_view extension = {});
/// Joints that the URDF already drives. For ros2_control, transmissions of ROS 1 are not included,
/// because it does not read them.
std::set<std::string_view> driven_joints(const LinkedModel& model, Actuation actuation);
/// Transmissions of ROS 1 to remove, because ros2_control drives all their joints.
std::vector<xml::View> replaced_transmissions(const LinkedModel& model, Actuation actuation);
/// Writes mesh and texture paths in the form of options.mesh_uri.
void rewrite_paths(const LinkedModel& model, const UrdfExport& options, XmlEdits& edits);

void strip_comments(const LinkedModel& model, XmlEdits& edits);
void strip_extensions(const LinkedModel& model, XmlEdits& edits);
struct CollapsedLink {
  std::string name;
  std::string carrier;  ///< the link that it is merged into
};
/// Merges links on fixed joints into the link that carries them, unless they or their joints are
/// kept, or an extension refers to the link itself (link_references.hpp).
std::vector<CollapsedLink> collapse_fixed(const LinkedModel& model,
                                          const std::vector<std::string>& keep, XmlEdits& edits);
/// A link of this name is the world: DART, Gazebo and MuJoCo fix attached bodies.
inline bool is_world(std::string_view link) { return link == "world"; }
/// Prefixes names of links, joints, materials and transmissions, and references; not the world.
void add_prefix(const LinkedModel& model, const std::string& prefix, XmlEdits& edits);
/// Where possible, replaces elements that `version` of URDF does not have.
void set_version(const LinkedModel& model, const std::string& version, XmlEdits& edits);
/// The attributes of limits that are new in URDF 1.2 and have no earlier equivalent.
std::vector<const xml::Attribute*> newer_limits(const LinkedModel& model, std::string_view version);
/// Adds a joint from a link `world` to the root.
void add_base(const LinkedModel& model, BaseJoint base, XmlEdits& edits);

/// Makes contact sensors of Gazebo name the collisions of `result` that they name in `source`.
void rename_contacts(const LinkedModel& source, const LinkedModel& result, XmlEdits& edits);
/// How many names in contact sensors are those of collisions in Gazebo.
std::size_t known_contacts(const LinkedModel& model);

/// Removes elements that URDF does not define from the robot, its links and joints.
std::vector<xml::View> extension_elements(const urdf::Robot& robot);

}  // namespace smurf::passes

namespace smurf {

/// Writes the whole document in canonical form: links and joints in the order of the tree,
/// attributes in a fixed order, the shortest numbers.
std::string canonical_urdf(const LinkedModel& model, std::string_view text);

}  // namespace smurf
