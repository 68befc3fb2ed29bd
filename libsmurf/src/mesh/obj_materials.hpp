// SPDX-License-Identifier: BSD-3-Clause
// The material libraries of an OBJ.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "smurf/mesh.hpp"
#include "smurf/mesh_triangles.hpp"

namespace smurf {

/// A file that a line of an OBJ or of a material library names.
MeshDependency mesh_dependency(std::string_view text, std::string_view name,
                               MeshDependency::Kind kind, std::uint32_t line);

/// The colours of the libraries that an OBJ names.
class ObjMaterials {
 public:
  /// `neighbours` may be null; then there are no colours.
  explicit ObjMaterials(const MeshNeighbours& neighbours) : neighbours_(neighbours) {}

  void read(std::string_view library);
  /// None if the material is unknown or states no diffuse colour (`Kd`).
  std::optional<Rgba> color_of(std::string_view material) const;
  /// A library names images.
  bool has_textures() const { return has_textures_; }

 private:
  const MeshNeighbours& neighbours_;
  std::set<std::string, std::less<>> libraries_;
  std::map<std::string, std::optional<Rgba>, std::less<>> colors_;
  bool has_textures_ = false;
};

}  // namespace smurf
