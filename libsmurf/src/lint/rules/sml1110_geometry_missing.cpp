// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "ast/urdf_schema.hpp"
#include "lint/geometry_queries.hpp"

namespace smurf::rules {
namespace {

/// Any that some reader knows, or a slip for one, which is reported as that.
bool has_shape(const LinkedModel& model, const urdf::Geometry& geometry) {
  constexpr std::string_view kShapes[] = {"box",  "sphere", "cylinder", "capsule",
                                          "mesh", "plane",  "cdf",      "ellipsoid"};
  const xml::View element(model.robot->document, geometry.element);
  return std::any_of(element.begin(), element.end(), [&](const xml::View child) {
    return std::ranges::count(kShapes, child.name()) > 0 || urdf::meant_name(child.name(), kShapes);
  });
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_geometry(model, [&](const GeometryUse& use) {
    const bool is_written = use.geometry.element != xml::kNoElement;
    if (is_written && has_shape(model, use.geometry)) return;
    if (!is_written && has_slip(model, use.element, "geometry")) return;
    const bool is_empty = use.geometry.shape_element == xml::kNoElement;
    findings.report(tag_name(model, is_written ? use.geometry.element : use.element),
                    "a " + std::string(to_string(use.role)) + " of " + title(use.link) +
                        (!is_written ? " has no geometry"
                         : is_empty  ? " has an empty geometry"
                                     : " has a geometry without a shape"));
  });
}

}  // namespace

extern constinit const Rule sml1110_geometry_missing{
    .id = "SML1110",
    .name = "geometry-missing",
    .severity = Severity::error,
    .summary = "A visual or collision has no geometry, or one without a shape.",
    .why = "urdfdom drops the rest of the link silently, Bullet refuses the robot, MuJoCo a "
           "collision; urdf-loader crashes.",
    .remedy = "Add a shape.",
    .sources = "urdfdom 3.0.1, Bullet, MuJoCo 3.14 and urdf-loader 0.13, executed.",
    .check_model = check};

}  // namespace smurf::rules
