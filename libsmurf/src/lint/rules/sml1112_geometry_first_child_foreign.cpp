// SPDX-License-Identifier: BSD-3-Clause
#include "lint/geometry_queries.hpp"

namespace smurf::rules {
namespace {

void check_geometry(const LinkedModel& model, const urdf::Link& link,
                    const urdf::Geometry& geometry, Findings& findings) {
  if (geometry.shape_element == xml::kNoElement) return;
  const xml::View first(model.robot->document, geometry.shape_element);
  if (is_shape(first.name())) return;
  for (const xml::View child : first.parent()) {
    // Shapes beyond URDF 1.0 are another defect of the same geometry.
    if (!is_shape(child.name())) continue;
    Diagnostic& diagnostic = findings.report(
        first.name_span(), quoted(first.name()) + " stands before the shape of this geometry");
    diagnostic.labels.push_back({child.name_span(), "the shape"});
    diagnostic.notes.push_back("urdfdom loses " + title(link) + " from here on");
    diagnostic.help = "put the shape first";
    return;
  }
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_geometry(model, [&](const GeometryUse& use) {
    check_geometry(model, use.link, use.geometry, findings);
  });
}

}  // namespace

extern constinit const Rule sml1112_geometry_first_child_foreign{
    .id = "SML1112",
    .name = "geometry-first-child-foreign",
    .severity = Severity::error,
    .summary = "The first element of a geometry is not its shape.",
    .why = "urdfdom and Bullet take the first child whatever it is: urdfdom drops the rest of the "
           "link and says nothing, Bullet refuses the robot. MuJoCo and Drake look for the shape "
           "by its name.",
    .remedy = "Move the shape to the front.",
    .sources = "urdfdom 3.0.1 link.cpp:224, executed; MuJoCo 3.14, executed; Drake "
               "detail_urdf_geometry.cc:318-346.",
    .check_model = check};

}  // namespace smurf::rules
