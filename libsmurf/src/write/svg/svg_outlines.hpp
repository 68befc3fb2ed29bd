// SPDX-License-Identifier: BSD-3-Clause
// The outlines of shapes in pictures: points whose hull is the outline.
#pragma once

#include <map>
#include <vector>

#include "write/pages/preview_meshes.hpp"

namespace smurf {

class SvgOutlines {
 public:
  /// `scene` must outlive this object.
  explicit SvgOutlines(const SceneExport& scene) : scene_(scene), files_(scene, {0, 0}) {}

  /// Points in the frame of the view, in which x goes right, y up, and z to the viewer. Empty for a
  /// mesh that is not drawn.
  std::vector<Vector3> of(const FlatGeometry& geometry, const Pose& X_VS);
  /// Whether some mesh is not drawn.
  bool lacks_meshes() const { return lacks_meshes_; }

 private:
  const std::vector<Vector3>& points_of(const std::string& file);

  const SceneExport& scene_;
  PreviewMeshes files_;
  std::map<std::string, std::vector<Vector3>> meshes_;
  std::size_t drawn_ = 0;
  bool lacks_meshes_ = false;
};

}  // namespace smurf
