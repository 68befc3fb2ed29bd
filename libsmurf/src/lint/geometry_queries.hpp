// SPDX-License-Identifier: BSD-3-Clause
// The shapes of a robot: every visual and collision of every link, walked in one place.
#pragma once

#include <functional>
#include <string_view>

#include "link/shape_boxes.hpp"
#include "link/shape_solids.hpp"
#include "lint/queries.hpp"

namespace smurf {

enum class GeometryRole : std::uint8_t { visual, collision };
std::string_view to_string(GeometryRole role);

/// A visual or collision and the link it belongs to. Valid as long as the model.
struct GeometryUse {
  GeometryRole role;
  const urdf::Link& link;
  xml::ElementId element;  ///< the visual or collision
  const Field<std::string>& name;
  const urdf::Origin& origin;
  const urdf::Geometry& geometry;

  /// Null if the shape is of another type.
  const urdf::Mesh* mesh() const { return std::get_if<urdf::Mesh>(&geometry.shape); }
};

/// The box of a shape in its own frame, in metres, with the mesh's scale. COLLADA is placed like
/// its triangles (smurf/mesh_triangles.hpp). None if the size is unknown or not finite.
std::optional<Box> bounding_box(const LinkedModel& model, const urdf::Geometry& geometry);

/// The smallest box around both.
Box united(const Box& a, const Box& b);

/// Whether most readers know the shape: shapes of URDF 1.0, and the capsule.
bool is_shape(std::string_view element_name);

/// Calls `visit` for every visual and collision: for each kind, link by link in document order.
void for_each_geometry(const LinkedModel& model,
                       const std::function<void(const GeometryUse&)>& visit);

}  // namespace smurf
