// SPDX-License-Identifier: BSD-3-Clause
// The texture coordinates in the sources of a <mesh> of COLLADA.
#pragma once

#include <cstdint>
#include <map>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "mesh/collada_file.hpp"
#include "mesh/triangle_collector.hpp"

namespace smurf::collada {

/// Each source is read once, even if many primitives name it.
class TextureSources {
 public:
  explicit TextureSources(xml::View mesh);

  /// The source that an <input> names; null if it does not exist.
  const std::vector<TexturePoint>* of(xml::View input);

 private:
  std::map<std::string_view, xml::View> by_id_;
  std::unordered_map<xml::ElementId, std::vector<TexturePoint>> read_;
};

/// Makes one point for each pair of a point and texture coordinates, because triangles have one
/// index for both.
class TexturedPoints {
 public:
  /// Replaces the indices of points by those of pairs, which are added to the lists. `textures` has
  /// the index of each corner in `source`.
  void join(const std::vector<std::int64_t>& textures, const std::vector<TexturePoint>& source,
            std::vector<std::uint32_t>& corners, std::vector<Vector3>& points,
            std::vector<TexturePoint>& texture_points);

 private:
  const std::vector<TexturePoint>* source_ = nullptr;
  std::unordered_map<std::uint64_t, std::uint32_t> pairs_;  ///< of that source
};

}  // namespace smurf::collada
