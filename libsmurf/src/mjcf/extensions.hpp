// SPDX-License-Identifier: BSD-3-Clause
// What a URDF says in `<gazebo>`: joints that close loops, springs of joints, and sensors with a
// place on a link.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "imports/joint_xml.hpp"
#include "mjcf/robot.hpp"

namespace smurf::mjcf {

class ExtensionWriter {
 public:
  /// `holders`: the joint of the URDF that holds a link, by the name of the link.
  ExtensionWriter(const Model& model, const JointFacts& facts,
                  const std::map<std::string, std::string>& holders, bool has_world,
                  Reporter& reporter, imports::TracedXml& xml)
      : model_(model),
        facts_(facts),
        holders_(holders),
        has_world_(has_world),
        reporter_(reporter),
        xml_(xml),
        parts_(model) {}

  void write_all();

 private:
  void loop(const ClosedLoop& loop);
  void springs();
  void sensor(const Reference& one);
  void camera(const Camera& camera);
  const Site* site_of(const Reference& one) const;
  void open_sensor(std::string_view reference, const std::string& name, std::string_view type,
                   const Pose& X_LS, const Place& tag);
  void close_sensor();

  const Model& model_;
  const JointFacts& facts_;
  const std::map<std::string, std::string>& holders_;
  bool has_world_;
  Reporter& reporter_;
  imports::TracedXml& xml_;
  PartsByName parts_;
  std::set<std::pair<std::string_view, const Site*>> known_;  ///< kinds of sensors at sites
};

}  // namespace smurf::mjcf
