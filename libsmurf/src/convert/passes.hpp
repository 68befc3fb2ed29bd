// SPDX-License-Identifier: BSD-3-Clause
// The steps of an export. Each edits the text that the step before it wrote, as byte edits: what no
// step is about stays as it was.
#pragma once

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
/// Motors whose joints no extension drives yet, as an extension that does.
void add_actuation(const LinkedModel& model, Actuation actuation, XmlEdits& edits);
/// Sensors as <gazebo><sensor>, those that Gazebo has and the URDF does not name yet.
void add_gazebo_sensors(const LinkedModel& model, XmlEdits& edits);
/// Gazebo's type of a sensor; "" when it has none.
std::string_view gazebo_type(const Sensor& sensor);
/// Mesh and texture paths, as options.mesh_uri wants them.
void rewrite_paths(const LinkedModel& model, const UrdfExport& options, XmlEdits& edits);

void strip_comments(const LinkedModel& model, XmlEdits& edits);
void strip_extensions(const LinkedModel& model, XmlEdits& edits);
/// Links on fixed joints become part of the link that carries them.
void collapse_fixed(const LinkedModel& model, std::string_view text, const UrdfExport& options,
                    XmlEdits& edits);
/// Names of links, joints, materials and transmissions, and all references to them.
void add_prefix(const LinkedModel& model, const std::string& prefix, XmlEdits& edits);
/// A joint from a link `world` to the root.
void add_base(const LinkedModel& model, BaseJoint base, XmlEdits& edits);

/// Elements that URDF does not define, of the robot, its links and joints.
std::vector<xml::View> extension_elements(const urdf::Robot& robot);

/// Links that stay when fixed joints are collapsed: those that move, those that extensions, mimics
/// or the keep list name.
std::vector<bool> kept_links(const LinkedModel& model, const std::vector<std::string>& keep);

using Attributes = std::vector<std::pair<std::string_view, std::string>>;
/// <name a="..."/>, values escaped.
std::string new_element(std::string_view name, const Attributes& attributes);
/// "1 0 0.5".
std::string numbers_text(const Vector3& vector);
Attributes origin_attributes(const Pose& pose);

}  // namespace smurf::passes

namespace smurf {

/// The whole document written anew: links and joints in the order of the tree, attributes in a
/// fixed order, the shortest numbers.
std::string canonical_urdf(const LinkedModel& model, std::string_view text);

}  // namespace smurf
