// SPDX-License-Identifier: BSD-3-Clause
#include "imports/joint_xml.hpp"

#include "imports/imports.hpp"

namespace smurf::imports {

void add_origin(TracedXml& xml, const Pose& X, const Place& tag, const Place& of_pose) {
  const Vector3 rpy = to_rpy(X.orientation);
  if (rpy == Vector3{} && X.position == Vector3{}) return;
  xml.open("origin", tag);
  if (rpy != Vector3{}) xml.attribute("rpy", words_of(rpy), of_pose);
  xml.attribute("xyz", words_of(X.position), of_pose);
  xml.close();
}

void open_joint(TracedXml& xml, const JointText& joint) {
  xml.open("joint", joint.tag, joint.is_made);
  xml.attribute("name", joint.name, joint.of_name, joint.is_name_made);
  xml.attribute("type", joint.type, joint.of_type);
  xml.open("parent", joint.tag);
  xml.attribute("link", joint.parent, joint.of_parent);
  xml.close();
  xml.open("child", joint.tag);
  xml.attribute("link", joint.child, joint.of_child);
  xml.close();
  add_origin(xml, joint.X_PJ, joint.tag, joint.of_pose);
}

void add_leaf(TracedXml& xml, std::string_view name, std::string_view text, const Place& place) {
  xml.open(name, place);
  xml.text(text, place);
  xml.close();
}

void open_loop(TracedXml& xml, const JointText& joint, const Pose& X_CJ) {
  xml.open("gazebo", joint.tag);
  xml.open("joint", joint.tag);
  xml.attribute("name", joint.name, joint.of_name, true);
  xml.attribute("type", joint.type, joint.of_type);
  add_leaf(xml, "parent", joint.parent, joint.of_parent);
  add_leaf(xml, "child", joint.child, joint.of_child);
  add_leaf(xml, "pose", words_of(X_CJ.position) + " " + words_of(to_rpy(X_CJ.orientation)),
           joint.of_pose);
}

void add_fixed_joint(TracedXml& xml, JointText joint) {
  joint.type = "fixed";
  joint.is_made = true;
  joint.blame_tag();
  open_joint(xml, joint);
  xml.close();
}

void add_made_link(TracedXml& xml, std::string_view name, const Place& tag) {
  xml.open("link", tag, true);
  xml.attribute("name", name, tag);
  xml.close();
}

}  // namespace smurf::imports
