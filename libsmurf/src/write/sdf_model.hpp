// SPDX-License-Identifier: BSD-3-Clause
// The parts of a model in SDF besides its links, shapes and joints: read once, written with each
// instance.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "write/sdf_parts.hpp"

namespace smurf {

/// The sensors of the annotations, and names of many shapes, which all instances share.
RepeatedParts sdf_parts(const LinkedModel& model);

class SdfModel {
 public:
  SdfModel(const LinkedModel& model, const SourceMap& sources);

  /// Sensors, plug-ins and settings of a link; see GazeboElements. SDF 1.6: those of the URDF.
  void add_to_link(XmlText& xml, std::size_t part, std::string_view frame, const Pose& X_BL,
                   bool is_old, UniqueNames& names) const;
  void add_to_joint(XmlText& xml, const urdf::Joint& joint, bool is_old, UniqueNames& names) const;

 private:
  void add_sensors(XmlText& xml, std::string_view carrier, std::string_view frame,
                   UniqueNames& names) const;

  const LinkedModel& model_;
  std::multimap<std::string, const Sensor*, std::less<>> sensors_;  ///< by link or joint

 public:
  CollisionContacts contacts;
  GazeboElements gazebo;
};

}  // namespace smurf
