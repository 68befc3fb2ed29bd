// SPDX-License-Identifier: BSD-3-Clause
// Joints of an SDF world. Joint poses are baked into the poses of the links and the limits shifted
// along, since SDF has no initial joint positions.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "write/losses/scene_losses.hpp"
#include "write/parts/loops.hpp"
#include "write/sdf/sdf_model.hpp"
#include "write/text/xml_text.hpp"

namespace smurf {

class SdfJoints {
 public:
  SdfJoints(const SceneExport& scene, bool is_old)
      : scene_(scene),
        is_old_(is_old),
        losses_(scene, is_old ? SceneColumn::sdf16 : SceneColumn::sdf, is_old ? "SDF 1.6" : "SDF") {
  }

 protected:
  const FlatInstance& flat(std::size_t i) const { return scene_.flat.instances[i]; }
  const LinkedModel* robot_of(std::size_t i) const { return smurf::robot_of(scene_.scene, i); }
  /// The names of its links, with those of nested models.
  const std::vector<std::string>& links_of(const LinkedModel& model);
  /// Facts about a model, computed once.
  const SdfModel& parts_of(const LinkedModel& model);
  void add_pose(const Pose& pose) { add_sdf_pose(xml_, pose, is_old_); }
  void add_fixed_joint(const std::string& name, const std::string& parent,
                       const std::string& child);
  /// `parent`: the name of its body; `scope`: the nested model that is open.
  void add_joint(std::size_t i, const LinkedModel& model, const SdfJoint& joint,
                 const std::string& parent, std::string_view scope);
  /// Adds a controller for each motor.
  void add_controllers(const LinkedModel& model);
  /// A joint to a second parent; its zero is at the start, as that of others.
  void add_loop(std::size_t i, const LinkedModel& model, const Loop& loop);

  const SceneExport& scene_;
  bool is_old_;
  SceneLosses losses_;
  LinkFrames frames_;
  XmlText xml_{scene_.most_bytes};
  /// Shapes and joints with a loss that was reported.
  std::set<std::pair<std::uint32_t, std::uint32_t>> reported_;

 private:
  void simplify(const urdf::Joint& joint, std::string_view written_as);
  double start_of(std::size_t i, const LinkedModel& model, const urdf::Joint& joint) const;
  void add_axis(std::size_t i, const LinkedModel& model, const urdf::Joint& joint, double start,
                const Pose& X_FJ = {}, std::string_view element = "axis");
  void add_mimic(std::size_t i, const LinkedModel& model, const urdf::Joint& joint);

  std::map<const LinkedModel*, std::vector<std::string>> links_;
  std::map<const LinkedModel*, std::unique_ptr<SdfModel>> models_;
};

}  // namespace smurf
