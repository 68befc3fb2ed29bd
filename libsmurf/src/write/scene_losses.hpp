// SPDX-License-Identifier: BSD-3-Clause
// What a scene loses on its way into another format, each loss at the token that says it.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "write/scene_things.hpp"

namespace smurf {

class SceneLosses {
 public:
  /// `format` as it is called in messages: "SDF". `scene` must outlive this.
  SceneLosses(const SceneExport& scene, SceneColumn column, std::string_view format)
      : scene_(scene), column_(column), format_(format) {}

  /// An entity that is not written at all. `why` is the end of "`X` is not written: ...".
  void entity(std::size_t instance, std::string_view why);
  void joint_pose(std::size_t instance, std::string_view why);
  void anchor(std::size_t instance, std::string_view why);
  /// A shape of a model or entity.
  void shape(Span span, std::string_view what);
  /// A shape that a preview has no triangles for. `reason` as in MeshTriangles; of a heightmap any.
  /// Reported once a place.
  void unseen_shape(Span span, const FlatGeometry& geometry, std::string_view reason);
  /// A joint that is written as something simpler.
  void joint(const urdf::Joint& joint, std::string_view written_as);
  /// A thing of the table that only the writer sees, by its title.
  void note(std::string_view title, Span span, const std::string& name) {
    noted_[title].try_emplace({to_size(span.source), span.begin}, FoundThing{span, name});
  }
  /// Reports everything in the scene that, by the table, the format does not keep.
  void table();

  /// Files that the result names and that lie in archives, which only our own tools look into: of
  /// every model its URDF, or its meshes when it is written out, and those of other entities.
  void files_in_archives();

 private:
  std::string path(std::size_t instance) const;
  Span place(std::size_t instance) const;
  std::vector<FoundThing> found(const SceneThing& thing, const LinkedModel& model) const;
  bool is_referred_to(const LinkedModel& model) const;
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
  std::set<std::pair<std::size_t, std::size_t>> unseen_;  ///< by source and place
  /// By title, then by source and place.
  std::map<std::string_view, std::map<std::pair<std::size_t, std::size_t>, FoundThing>> noted_;
};

}  // namespace smurf
