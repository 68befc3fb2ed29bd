// SPDX-License-Identifier: BSD-3-Clause
#include "lint/geometry_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_geometry(model, [&](const GeometryUse& use) {
    if (use.geometry.shape_element != xml::kNoElement) return;
    const bool is_empty = use.geometry.element != xml::kNoElement;
    if (!is_empty && has_slip(model, use.element, "geometry")) return;
    findings.report(tag_name(model, is_empty ? use.geometry.element : use.element),
                    "a " + std::string(to_string(use.role)) + " of " + title(use.link) +
                        (is_empty ? " has an empty geometry" : " has no geometry"));
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
