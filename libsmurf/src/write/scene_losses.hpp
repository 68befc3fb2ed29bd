// SPDX-License-Identifier: BSD-3-Clause
// What a scene loses on its way into another format, each loss at the token that says it.
#pragma once

#include <initializer_list>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "smurf/write_scene.hpp"

namespace smurf {

class SceneLosses {
 public:
  /// `format` as it is called in messages: "SDF". `scene` must outlive this.
  SceneLosses(const SceneExport& scene, std::string_view format) : scene_(scene), format_(format) {}

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
  /// Keys that only SMURF has: of every entity with keys of its own, the annotations of every
  /// model, and what old scenes hold besides shapes and lights.
  void annotations_and_properties();

  /// Files that the result names and that lie in archives, which only our own tools look into: of
  /// every model its URDF, or its meshes when it is written out, and those of other entities.
  void files_in_archives();

  enum class World : std::uint8_t { gravity, step_size, solver, environment, lights };
  /// Of these settings, those that the scene has.
  void world(std::initializer_list<World> settings);

 private:
  std::string path(std::size_t instance) const;
  Span place(std::size_t instance) const;
  void old_scenes();
  std::vector<std::string> archived_files(std::size_t instance) const;
  void report_world(World setting, const SceneFile& file);

  const SceneExport& scene_;
  std::string format_;
  std::set<std::pair<std::size_t, std::size_t>> unseen_;  ///< by source and place
};

}  // namespace smurf
