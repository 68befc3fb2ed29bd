// SPDX-License-Identifier: BSD-3-Clause
// The diffuse colours of the materials of COLLADA.
#pragma once

#include <map>
#include <optional>
#include <string_view>

#include "mesh/collada_file.hpp"
#include "smurf/mesh_triangles.hpp"

namespace smurf::collada {

/// The ids of materials, by their symbols in a geometry.
using Bindings = std::map<std::string_view, std::string_view>;
Bindings bindings_of(xml::View instance);

class Colors {
 public:
  explicit Colors(xml::View root);

  /// None for a texture.
  std::optional<Rgba> of(std::string_view material) const;
  /// Whether any effect of the file has a texture.
  bool has_textures() const { return has_textures_; }

 private:
  std::map<std::string_view, std::optional<Rgba>> colors_;  ///< by the id of a material
  bool has_textures_ = false;
};

}  // namespace smurf::collada
