// SPDX-License-Identifier: BSD-3-Clause
// Motors as the systems of Gazebo that command joints. Read in the sources of gz-sim 6 to 10; not
// run.
#pragma once

#include <string>
#include <vector>

#include "write/parts/joint_drives.hpp"
#include "write/sdf/sdf_tree.hpp"
#include "write/text/xml_text.hpp"

namespace smurf {

/// The drives that become controllers: those of motors, and, when the caller asks for motors, of
/// all joints. Transmissions and ros2_control belong to a plug-in that reads them from a URDF.
/// None if a plug-in of the model commands joints already, and none for joints that are a part of
/// an SDF joint with several axes.
std::vector<JointDrive> sdf_drives(const LinkedModel& model, const SdfTree& tree,
                                   const MotorOptions& options);
/// Whether a plug-in of the model commands its joints, such as that of ros2_control.
bool has_own_controllers(const LinkedModel& model);

/// The plug-in of one motor, in <model>. `joint`: its name there, with those of nested models. The
/// zero of the joint is its start position. The motor moves its joint as the command says, within
/// its speed and the effort limit of the joint, which is stable at every step; its force comes from
/// gains only if the caller chose some, since Gazebo integrates them explicitly.
void add_sdf_controller(XmlText& xml, const JointDrive& drive, const std::string& joint,
                        const MotorOptions& options);

}  // namespace smurf
