// SPDX-License-Identifier: BSD-3-Clause
// What becomes of motors, and of the elements of a URDF that drive joints.
#include <set>

#include "base/text/quoted.hpp"
#include "convert/import.hpp"
#include "write/losses/found_things.hpp"
#include "write/parts/joint_drives.hpp"
#include "write/sdf/sdf_controllers.hpp"

namespace smurf::things {
namespace {

constexpr std::size_t kMostOfDriver = 240;  ///< bytes of a name, as in found_things.cpp

/// Whether a format has actuators.
bool has_drives(SceneColumn column) {
  return column == SceneColumn::mjcf || column == SceneColumn::usda;
}

FollowerDrives followers_in(SceneColumn column) {
  return column == SceneColumn::mjcf ? FollowerDrives::as_written : FollowerDrives::none;
}

/// Whether an actuator or drive has what this part of a transmission or ros2_control states. Its
/// own parts are considered separately. Drives of USD have no limits of positions.
bool is_said_by_drive(xml::View part, const std::set<xml::ElementId>& commands,
                      SceneColumn column) {
  const std::string_view name = part.name();
  if (name == "mechanicalReduction") return import::text_of(part) == "1";
  if (name == "command_interface") return commands.contains(part.id());
  if (name == "param" && commands.contains(part.parent().id())) {
    const std::string_view limit = attribute_of(part, "name");
    const bool is_position = attribute_of(part.parent(), "name") == "position";
    return is_position ? column == SceneColumn::mjcf && (limit == "min" || limit == "max")
                       : limit == "max";
  }
  return name == "type" || name == "joint" || name == "actuator" || name == "hardwareInterface";
}

void add_unsaid_settings(xml::View element, const std::string& driver,
                         const std::set<xml::ElementId>& commands, SceneColumn column,
                         Found& found) {
  for (const xml::View part : element) {
    if (is_said_by_drive(part, commands, column)) {
      add_unsaid_settings(part, driver, commands, column, found);
    } else {
      found.push_back({part.name_span(), std::string(part.name()) + " of " + driver});
    }
  }
}

Found drivers(const LinkedModel& model, SceneColumn column, const MotorOptions& options,
              std::string_view element) {
  Found found;
  if (!model.robot) return found;
  std::set<xml::ElementId> written;
  std::set<xml::ElementId> commands;
  if (has_drives(column)) {
    for (const JointDrive& drive : joint_drives(model, options, followers_in(column))) {
      written.insert(drive.element);
      commands.insert(drive.command);
    }
  }
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View view(model.robot->document, id);
    if (view.name() != element) continue;
    if (written.contains(id)) {
      add_unsaid_settings(view, shortened(name_or_tag(view), kMostOfDriver), commands, column,
                          found);
    } else {
      found.push_back({view.name_span(), name_or_tag(view)});
    }
  }
  return found;
}

}  // namespace

Found efforts(const LinkedModel& model, SceneColumn column, const MotorOptions& options) {
  std::set<const urdf::Joint*> driven;
  if (column == SceneColumn::mjcf) {
    for (const JointDrive& drive : joint_drives(model, options, followers_in(column)))
      driven.insert(drive.joint);
  }
  Found found;
  if (!model.robot) return found;
  for (const urdf::Joint& joint : model.robot->joints) {
    if (!joint.limit || !joint.limit->effort || driven.contains(&joint)) continue;
    found.push_back({joint.limit->effort.span, joint.name.value_or({})});
  }
  return found;
}

Found chosen_gains(const LinkedModel& model, SceneColumn column, const MotorOptions& options) {
  Found found;
  for (const JointDrive& drive : joint_drives(model, options)) {
    if (drive.kind == DriveKind::effort) continue;
    if (column == SceneColumn::mjcf && drive.has_own_gains) continue;
    if (drive.has_gains_of_controller && drive.kv) continue;
    found.push_back({drive.motor != nullptr ? drive.motor->span : drive.joint->span,
                     shortened(drive.name, kMostOfDriver)});
  }
  return found;
}

Found transmissions(const LinkedModel& model, SceneColumn column, const MotorOptions& options) {
  return column == SceneColumn::dmd ? Found() : drivers(model, column, options, "transmission");
}

Found ros2_controls(const LinkedModel& model, SceneColumn column, const MotorOptions& options) {
  if (column != SceneColumn::dmd) return drivers(model, column, options, "ros2_control");
  Found found;
  if (!model.robot) return found;
  std::set<std::string_view> driven;
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View element(model.robot->document, id);
    if (element.name() != "transmission" || !element.child("joint")) continue;
    driven.insert(attribute_of(element.child("joint"), "name"));
  }
  for (const JointDrive& drive : joint_drives(model)) {
    const bool is_lost = drive.motor == nullptr && !driven.contains(*drive.joint->name);
    if (is_lost) found.push_back({drive.joint->span, *drive.joint->name});
  }
  return found;
}

Found motors(const LinkedModel& model, SceneColumn column, const MotorOptions&) {
  const bool has_controllers = column == SceneColumn::sdf && !has_own_controllers(model);
  if (!has_drives(column) && !has_controllers) return entries<&Annotations::motors>(model, column);
  Found found;
  for (const Motor* motor : idle_motors(model, followers_in(column))) {
    found.push_back({motor->span, motor->name.value_or({})});
  }
  return found;
}

Found motor_keys(const LinkedModel& model, SceneColumn column) {
  std::vector<std::string_view> said{"name",        "joint",     "type",        "p",
                                     "maxSpeed",    "maxEffort", "mimic_motor", "mimic_multiplier",
                                     "mimic_offset"};
  if (column == SceneColumn::sdf && has_own_controllers(model)) return {};
  if (column == SceneColumn::sdf) {
    std::erase(said, "p");
    std::erase(said, "maxEffort");
  }
  if (column == SceneColumn::mjcf) {
    said.insert(said.end(), {"minValue", "maxValue", "minPosition", "maxPosition", "minEffort",
                             "kp", "kv", "armature"});
  }
  Found found;
  for (const Motor& motor : model.annotations.motors) {
    append(found, other_keys(model, motor, said));
  }
  return found;
}

}  // namespace smurf::things
