// SPDX-License-Identifier: BSD-3-Clause
#include "lint/geometry_queries.hpp"

namespace smurf {

std::string_view to_string(GeometryRole role) {
  return role == GeometryRole::visual ? "visual" : "collision";
}

void for_each_geometry(const LinkedModel& model,
                       const std::function<void(const GeometryUse&)>& visit) {
  for_each_link(model, [&](const urdf::Link& link) {
    for (const urdf::Visual& visual : link.visuals) {
      visit({GeometryRole::visual, link, visual.element, visual.origin, visual.geometry});
    }
    for (const urdf::Collision& collision : link.collisions) {
      visit(
          {GeometryRole::collision, link, collision.element, collision.origin, collision.geometry});
    }
  });
}

}  // namespace smurf
