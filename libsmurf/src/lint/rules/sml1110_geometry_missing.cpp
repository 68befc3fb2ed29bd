// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check_geometry(const LinkedModel& model, const urdf::Link& link, std::string_view what,
                    xml::ElementId element, const urdf::Geometry& geometry, Findings& findings) {
  if (geometry.shape_element != xml::kNoElement) return;
  const bool is_empty = geometry.element != xml::kNoElement;
  findings.report(tag_name(model, is_empty ? geometry.element : element),
                  "a " + std::string(what) + " of " + title(link) +
                      (is_empty ? " has an empty geometry" : " has no geometry"));
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_link(model, [&](const urdf::Link& link) {
    for (const urdf::Visual& visual : link.visuals) {
      check_geometry(model, link, "visual", visual.element, visual.geometry, findings);
    }
    for (const urdf::Collision& collision : link.collisions) {
      check_geometry(model, link, "collision", collision.element, collision.geometry, findings);
    }
  });
}

}  // namespace

extern constinit const Rule sml1110_geometry_missing{
    .id = "SML1110",
    .name = "geometry-missing",
    .severity = Severity::error,
    .summary = "A visual or collision has no geometry, or an empty one.",
    .why = "urdfdom drops the rest of the link silently, Bullet refuses the robot, MuJoCo a "
           "collision; urdf-loader crashes.",
    .remedy = "Add a shape.",
    .sources = "urdfdom 3.0.1, Bullet, MuJoCo 3.14 and urdf-loader 0.13, executed.",
    .check_model = check};

}  // namespace smurf::rules
