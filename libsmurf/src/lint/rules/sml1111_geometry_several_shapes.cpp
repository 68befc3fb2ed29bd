// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/geometry_queries.hpp"

namespace smurf::rules::sml1111_geometry_several_shapes_file {
namespace {

constexpr Circumstance kSame{"same"};

void check_geometry(const LinkedModel& model, const urdf::Geometry& geometry, Findings& findings) {
  if (geometry.element == xml::kNoElement) return;
  const xml::View element(model.robot->document, geometry.element);
  xml::View first;
  for (const xml::View child : element) {
    if (!is_shape(child.name())) continue;
    if (first) {
      Diagnostic& diagnostic = findings.report(child.name_span(), "a second shape in one geometry");
      diagnostic.label(first.name_span(), "the first one");
      if (first.name() == child.name()) diagnostic.when(kSame);
      return;
    }
    first = child;
  }
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_geometry(model,
                    [&](const GeometryUse& use) { check_geometry(model, use.geometry, findings); });
}

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::changes, "uses the first shape", "urdfdom, Bullet, run"},
    {&readers::phobos, Effect::refuses, "stops with an AssertionError", "Phobos a613e31, run"},
    {&readers::mujoco, Effect::refuses, "refuses a repeated element", kRun, when(kSame)},
    {&readers::mujoco, Effect::changes,
     "uses the box, else the cylinder, else the sphere, else the mesh", "MuJoCo xml_urdf.cc, run"},
    {&readers::drake, Effect::changes,
     "uses the box, else the sphere, else the cylinder, else the mesh", kRun},
};

}  // namespace

extern constinit const Rule sml1111_geometry_several_shapes{
    .id = "SML1111",
    .name = "geometry-several-shapes",
    .severity = Severity::error,
    .summary = "A geometry contains more than one shape.",
    .remedy = "Write one visual or collision for each shape.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1111_geometry_several_shapes_file
