// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <vector>

#include "ast/urdf_schema.hpp"
#include "lint/geometry_queries.hpp"

namespace smurf::rules {
namespace {

/// Any that some reader knows, or a slip for one, which is reported as that.
bool has_shape(const LinkedModel& model, const urdf::Geometry& geometry) {
  const urdf::ElementSpec& spec = *urdf::find_element_spec("geometry");
  std::vector<std::string_view> shapes;
  for (const urdf::ChildSpec& child : spec.children) shapes.push_back(child.name);
  const xml::View element(model.robot->document, geometry.element);
  return std::any_of(element.begin(), element.end(), [&](const xml::View child) {
    const bool is_vendors =  // `verbose` is no shape
        child.name() != "verbose" && std::ranges::count(spec.extensions, child.name()) > 0;
    return is_vendors || std::ranges::count(shapes, child.name()) > 0 ||
           urdf::meant_name(child.name(), shapes).has_value();
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
