// SPDX-License-Identifier: BSD-3-Clause
// Joints of a URDF, and the links that only they need.
#pragma once

#include <string_view>

#include "imports/traced_xml.hpp"
#include "smurf/pose.hpp"

namespace smurf::imports {

/// A joint without its axis, and where its parts were written.
struct JointText {
  std::string_view name = {}, type = {}, parent = {}, child = {};
  Pose X_PJ = {};  ///< of the joint in the frame of its parent
  Place tag = {}, of_name = {}, of_type = {}, of_parent = {}, of_child = {}, of_pose = {};
  bool is_made = false;       ///< nobody wrote the joint
  bool is_name_made = false;  ///< nobody wrote the name

  /// All parts are blamed on the tag, but for the pose.
  void blame_tag() { of_name = of_type = of_parent = of_child = tag; }
};

/// Opens a `<joint>`; the caller adds what else it has, and closes it.
void open_joint(TracedXml& xml, const JointText& joint);
/// A fixed joint that nobody wrote.
void add_fixed_joint(TracedXml& xml, JointText joint);
/// A link without mass between two joints.
void add_made_link(TracedXml& xml, std::string_view name, const Place& tag);
/// Opens a `<joint>` in `<gazebo>`, which closes a loop of the tree, at its pose in the child. The
/// caller adds what else it has, and closes both.
void open_loop(TracedXml& xml, const JointText& joint, const Pose& X_CJ);
/// `<pose>0 0 1 0 0 0</pose>`
void add_leaf(TracedXml& xml, std::string_view name, std::string_view text, const Place& place);
/// An `<origin>`, unless the pose is the identity.
void add_origin(TracedXml& xml, const Pose& X, const Place& tag, const Place& of_pose);

}  // namespace smurf::imports
