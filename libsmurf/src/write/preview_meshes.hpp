// SPDX-License-Identifier: BSD-3-Clause
// The mesh files of a preview. Each is read once; a limit applies to all of them together.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "smurf/source.hpp"
#include "smurf/write_scene.hpp"

namespace smurf {

/// Whether the file gives any part a colour.
bool has_colors(const std::vector<MeshPart>& parts);

class PreviewMeshes {
 public:
  /// The least bytes that a format needs for a point and for an index of a triangle.
  struct Cost {
    std::uint64_t point_bytes, index_bytes;
    std::uint64_t texture_point_bytes = 0;
  };

  /// `scene` must outlive this.
  PreviewMeshes(const SceneExport& scene, Cost cost) : scene_(scene), cost_(cost) {}

  /// The name under which a file was first asked for. Links may give a file thousands of names.
  const std::string& first_name(const std::string& file);

  /// No triangles, and a finding at `place`, when those of all files would be too many to write.
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
