// SPDX-License-Identifier: BSD-3-Clause
// Reports what a scene loses in another format, each loss at the token that is lost.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "write/losses/loss_table.hpp"

namespace smurf {

class SceneLosses {
 public:
  /// `format` is the name for messages: "SDF". `scene` must outlive this object.
  SceneLosses(const SceneExport& scene, SceneColumn column, std::string_view format)
      : scene_(scene), column_(column), format_(format) {}

  /// Reports an entity that is not written. `why` is the end of "`X` is not written: ...".
  void entity(std::size_t instance, std::string_view why);
  void joint_pose(std::size_t instance, std::string_view why);
  void anchor(std::size_t instance, std::string_view why);
  /// Reports a shape of a model or entity that is not written.
  void shape(Span span, std::string_view what);
  /// Reports a shape without triangles for a preview. `reason` is as in MeshTriangles, or any text
  /// for a heightmap. Reported once per place.
  void unseen_shape(Span span, const FlatGeometry& geometry, std::string_view reason);
  /// The package of a mesh with an address, if no file of it is there; otherwise empty.
  std::string_view lost_package(std::string_view file) const;
  /// Reports a joint that is written as a simpler type. `written_as` fits one joint and several.
  void joint(const urdf::Joint& joint, std::string_view written_as);
  /// The axis of a joint for the format, as joint_axis(). Reports a joint whose axis is zero once;
  /// it has the axis x.
  Vector3 axis_of(const urdf::Joint& joint);
  /// Reports a thing of the table that only the writer can find, by its title.
  void note(std::string_view title, Span span, const std::string& name) {
    noted_[title].try_emplace({to_size(span.source), span.begin}, FoundThing{span, name});
  }
  /// Reports everything in the scene that the format does not keep, according to the table.
  void table();

  /// Reports files in archives, which only our own tools read, that the result names: the URDF of
  /// each model, or the meshes of one that is written out, and the files of other entities.
  void files_in_archives();

 private:
  std::string path(std::size_t instance) const;
  Span place(std::size_t instance) const;
  std::vector<FoundThing> found(const SceneThing& thing, const LinkedModel& model) const;
  bool is_referred_to(const LinkedModel& model) const;
  std::string why_unseen(const std::string& file, std::string_view reason) const;
  bool has_found(std::string_view package) const;
  void of_model(const LinkedModel& model);
  void of_scene(const SceneThing& thing);
  void report(const SceneThing& thing, const std::vector<FoundThing>& found);
  void unknown_entities();
  void old_scenes();
  std::vector<std::string> archived_files(std::size_t instance) const;
  void report_setting(WorldSetting setting, const SceneFile& file);
  void lights_of_old_scenes();

  const SceneExport& scene_;
  SceneColumn column_;
  std::string format_;
  std::set<std::tuple<std::size_t, std::size_t, std::string>> unseen_;  ///< source, place and file
  std::set<const urdf::Joint*> without_axis_;  ///< those that were reported
  /// By title, then by source and place.
  std::map<std::string_view, std::map<std::pair<std::size_t, std::size_t>, FoundThing>> noted_;
};

}  // namespace smurf
