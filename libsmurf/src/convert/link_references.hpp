// SPDX-License-Identifier: BSD-3-Clause
// The references of URDF extensions to links that matter when links are merged.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "convert/xml_edits.hpp"
#include "smurf/linked.hpp"

namespace smurf {

class LinkReferences {
 public:
  explicit LinkReferences(const LinkedModel& model);

  /// Whether something refers to the link or joint itself: its frame, a plugin, a transmission, a
  /// mimic, or an extension inside of it.
  bool needs(std::string_view name) const { return needed_.contains(name); }

  /// Whether the Gazebo settings of both links (friction, colour, ...) are compatible.
  bool may_join(const urdf::Link& link, const urdf::Link& carrier) const;

  /// Moves the sensors of the link to its carrier; deletes settings that the carrier also
  /// has.
  void move(const std::string& link, const std::string& carrier, const Pose& X_CL,
            XmlEdits& edits) const;

 private:
  void read_gazebo(xml::View gazebo, std::string_view link);
  void read_sensor(xml::View sensor);
  void read_names(xml::View element);
  const std::vector<std::string>& properties(std::string_view link) const;

  const LinkedModel& model_;
  std::set<std::string_view> needed_;
  std::map<std::string_view, std::vector<xml::View>> gazebo_, sensors_;  ///< by link
  /// By link: the settings for Gazebo except sensors and plugins, as sorted signatures.
  std::map<std::string_view, std::vector<std::string>> properties_;
};

}  // namespace smurf
