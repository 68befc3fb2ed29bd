// SPDX-License-Identifier: BSD-3-Clause
// The shapes of a robot: every visual and collision of every link, walked in one place.
#pragma once

#include <functional>
#include <string_view>

#include "lint/queries.hpp"

namespace smurf {

enum class GeometryRole : std::uint8_t { visual, collision };
std::string_view to_string(GeometryRole role);

/// A visual or collision and the link it belongs to. Valid as long as the model.
struct GeometryUse {
  GeometryRole role;
  const urdf::Link& link;
  xml::ElementId element;  ///< the visual or collision
  const urdf::Origin& origin;
  const urdf::Geometry& geometry;

  /// Null when the shape is another.
  const urdf::Mesh* mesh() const { return std::get_if<urdf::Mesh>(&geometry.shape); }
};

/// Calls `visit` for every visual and collision, in document order within each kind of a link.
void for_each_geometry(const LinkedModel& model,
                       const std::function<void(const GeometryUse&)>& visit);

}  // namespace smurf
