// SPDX-License-Identifier: BSD-3-Clause
#include "write/sdf/sdf_controllers.hpp"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "syntax/xml_values.hpp"

namespace smurf {
namespace {

/// gz_ros2_control, gazebo_ros_control, the controllers of gz-sim, and their like.
bool commands_joints(xml::View plugin) {
  constexpr std::string_view kWords[] = {"ros2_control", "ros_control", "joint-controller",
                                         "joint-position-controller",
                                         "joint-trajectory-controller"};
  const std::string_view file = attribute_of(plugin, "filename");
  return plugin.name() == "plugin" &&
         std::any_of(std::begin(kWords), std::end(kWords), [&](std::string_view word) {
           return file.find(word) != std::string_view::npos;
         });
}

}  // namespace

bool has_own_controllers(const LinkedModel& model) {
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View gazebo(model.robot->document, id);
    if (gazebo.name() != "gazebo") continue;
    for (const xml::View child : gazebo) {
      if (commands_joints(child)) return true;
    }
  }
  return false;
}

std::vector<JointDrive> sdf_drives(const LinkedModel& model, const SdfTree& tree,
                                   const MotorOptions& options) {
  std::vector<JointDrive> drives;
  if (!model.robot || has_own_controllers(model)) return drives;
  const bool wants_all = options.kind != MotorKind::as_written;
  std::set<const urdf::Joint*> written;
  for (const SdfJoint& joint : tree.joints) {
    const bool is_screw = joint.kind == SdfJointKind::screw;
    if (joint.kind != SdfJointKind::ball && !is_screw) written.insert(joint.joint);
  }
  for (JointDrive& drive : joint_drives(model, options)) {
    if ((drive.motor != nullptr || wants_all) && written.contains(drive.joint))
      drives.push_back(std::move(drive));
  }
  return drives;
}

void add_sdf_controller(XmlText& xml, const JointDrive& drive, const std::string& joint,
                        const MotorOptions& options) {
  const bool has_gains = (!options.kp.empty() && drive.kp) || (!options.kv.empty() && drive.kv);
  const auto open = [&](const std::string& file, const std::string& system) {
    xml.open("plugin",
             {{"filename", "gz-sim-" + file + "-system"}, {"name", "gz::sim::systems::" + system}});
    xml.leaf("joint_name", joint);
  };
  const auto gains = [&](double p, double d) {
    xml.leaf("p_gain", p);
    xml.leaf("i_gain", 0);
    xml.leaf("d_gain", d);
    if (!drive.effort) return;
    xml.leaf("cmd_max", *drive.effort);
    xml.leaf("cmd_min", -*drive.effort);
  };
  const DriveGains stated = gains_of(drive);
  switch (drive.kind) {
  case DriveKind::position:
    open("joint-position-controller", "JointPositionController");
    if (has_gains) {
      gains(stated.kp, stated.kv);
    } else {
      xml.leaf("use_velocity_commands", "true");
      if (drive.speed) xml.leaf("cmd_max", *drive.speed);
    }
    break;
  case DriveKind::velocity:
    open("joint-controller", "JointController");
    if (has_gains) {
      xml.leaf("use_force_commands", "true");
      gains(stated.kv, 0);
    }
    break;
  case DriveKind::effort: open("apply-joint-force", "ApplyJointForce"); break;
  }
  xml.close();
}

}  // namespace smurf
