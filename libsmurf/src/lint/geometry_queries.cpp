// SPDX-License-Identifier: BSD-3-Clause
#include "lint/geometry_queries.hpp"

#include <algorithm>
#include <cmath>

namespace smurf {

std::string_view to_string(GeometryRole role) {
  return role == GeometryRole::visual ? "visual" : "collision";
}

std::optional<Box> bounding_box(const LinkedModel& model, const urdf::Geometry& geometry) {
  // A misspelt scale is reported at its place, and its meaning is unknown.
  const bool is_mesh = std::holds_alternative<urdf::Mesh>(geometry.shape);
  if (is_mesh && has_slip(model, geometry.shape_element, "scale")) return std::nullopt;
  return box_of(model, geometry);
}

Box united(const Box& a, const Box& b) {
  Box box = a;
  for (std::size_t i = 0; i < 3; ++i) {
    box.low[i] = std::min(a.low[i], b.low[i]);
    box.high[i] = std::max(a.high[i], b.high[i]);
  }
  return box;
}

bool is_shape(std::string_view element_name) {
  constexpr std::string_view kShapes[] = {"box", "sphere", "cylinder", "capsule", "mesh"};
  return std::find(std::begin(kShapes), std::end(kShapes), element_name) != std::end(kShapes);
}

void for_each_geometry(const LinkedModel& model,
                       const std::function<void(const GeometryUse&)>& visit) {
  for_each_link(model, [&](const urdf::Link& link) {
    for (const urdf::Visual& visual : link.visuals) {
      visit({GeometryRole::visual, link, visual.element, visual.name, visual.origin,
             visual.geometry});
    }
    for (const urdf::Collision& collision : link.collisions) {
      visit({GeometryRole::collision, link, collision.element, collision.name, collision.origin,
             collision.geometry});
    }
  });
}

}  // namespace smurf
