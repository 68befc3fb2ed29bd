// SPDX-License-Identifier: BSD-3-Clause
// The mesh files of a preview. Each is read once; a limit applies to all of them together.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "smurf/source.hpp"
#include "smurf/write_scene.hpp"

namespace smurf {

/// Whether any part of the file has a colour.
bool has_colors(const std::vector<MeshPart>& parts);

class PreviewMeshes {
 public:
  /// The fewest bytes that a format needs for a point and for an index of a triangle.
  struct Cost {
    std::uint64_t point_bytes, index_bytes;
    std::uint64_t texture_point_bytes = 0;
  };

  /// `scene` must outlive this object.
  PreviewMeshes(const SceneExport& scene, Cost cost) : scene_(scene), cost_(cost) {}

  /// The first name under which a file was requested. Links may give a file thousands of names.
  const std::string& first_name(const std::string& file);

  /// If all files have too many triangles to write, reports a finding at `place` and returns none.
  MeshTriangles read(const std::string& file, Span place,
                     TexturePoints texture_points = TexturePoints::ignored);

 private:
  const SceneExport& scene_;
  Cost cost_;
  std::map<std::string, std::string> by_name_;
  std::map<std::string, std::string> by_identity_;
  std::uint64_t bytes_ = 0;
};

}  // namespace smurf
