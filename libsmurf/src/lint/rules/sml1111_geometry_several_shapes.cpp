// SPDX-License-Identifier: BSD-3-Clause
#include "lint/geometry_queries.hpp"

namespace smurf::rules {
namespace {

void check_geometry(const LinkedModel& model, const urdf::Geometry& geometry, Findings& findings) {
  if (geometry.element == xml::kNoElement) return;
  const xml::View element(model.robot->document, geometry.element);
  xml::View first;
  for (const xml::View child : element) {
    if (!is_shape(child.name())) continue;
    if (first) {
      Diagnostic& diagnostic = findings.report(child.name_span(), "a second shape in one geometry");
      diagnostic.labels.push_back({first.name_span(), "the first one"});
      return;
    }
    first = child;
  }
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_geometry(model,
                    [&](const GeometryUse& use) { check_geometry(model, use.geometry, findings); });
}

}  // namespace

extern constinit const Rule sml1111_geometry_several_shapes{
    .id = "SML1111",
    .name = "geometry-several-shapes",
    .severity = Severity::error,
    .summary = "A geometry holds more than one shape.",
    .why = "urdfdom and Bullet take the first shape, MuJoCo and Drake the first in an order of "
           "their own.",
    .remedy = "Write one visual or collision for each shape.",
    .sources = "urdfdom 3.0.1 link.cpp:224, MuJoCo 3.14 and Bullet, executed.",
    .check_model = check};

}  // namespace smurf::rules
