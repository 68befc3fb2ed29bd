// SPDX-License-Identifier: BSD-3-Clause
// The parts of a model in SDF besides its links, shapes and joints: read once, written with each
// instance.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "write/sdf/sdf_names.hpp"
#include "write/sdf/sdf_parts.hpp"
#include "write/sdf/sdf_tree.hpp"

namespace smurf {

/// The sensors and motors of the annotations, and names of many shapes, which all instances share.
RepeatedParts sdf_parts(const LinkedModel& model);

class SdfModel {
 public:
  SdfModel(const LinkedModel& model, const SceneExport& scene);

  /// Sensors, plug-ins and settings of a link; see GazeboElements. SDF 1.6: those of the URDF.
  void add_to_link(XmlText& xml, std::size_t part, std::string_view frame, const Pose& X_BL,
                   bool is_old, UniqueNames& names) const;
  void add_to_joint(XmlText& xml, const urdf::Joint& joint, bool is_old, UniqueNames& names) const;
  /// Places and names of collisions that a contact sensor cannot name, because they are in another
  /// body.
  const std::vector<std::pair<Span, std::string>>& lost_contacts() const { return lost_contacts_; }

 private:
  void name_contacts();
  void add_sensors(XmlText& xml, std::string_view carrier, std::string_view frame,
                   UniqueNames& names) const;

  const LinkedModel& model_;
  std::multimap<std::string, const Sensor*, std::less<>> sensors_;  ///< by link or joint
  std::vector<std::pair<Span, std::string>> lost_contacts_;

 public:
  SdfTree tree;
  SdfShapeNames shape_names;
  CollisionContacts contacts;
  GazeboElements gazebo;
};

/// The plug-ins of the world that run the sensors of its models, for Gazebo Fortress and later.
void add_sdf_systems(XmlText& xml, const LinkedScene& scene);
/// Whether a sensor of the model needs one.
bool needs_sdf_systems(const LinkedModel& model);

}  // namespace smurf
