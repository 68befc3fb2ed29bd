// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/geometry_queries.hpp"

namespace smurf::rules::sml1112_geometry_first_child_foreign_file {
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
        first.name_span(), quoted(first.name()) + " comes before the shape of this geometry");
    diagnostic.label(child.name_span(), "the shape");
    diagnostic.note("urdfdom loses " + title(link) + " from here on");
    diagnostic.help("put the shape first");
    return;
  }
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_geometry(model, [&](const GeometryUse& use) {
    check_geometry(model, use.link, use.geometry, findings);
  });
}

constexpr Fact kFacts[] = {
    urdfdom_drops_shapes({}, "urdfdom link.cpp:224, run"),
    {&readers::pybullet, Effect::refuses, "refuses the whole robot", "Bullet UrdfParser.cpp, run"},
    {&readers::mujoco, Effect::takes, "looks for the shape by its name", kRun},
    {&readers::drake, Effect::takes, "looks for the shape by its name", kRun},
    {&readers::phobos, Effect::takes, "looks for the shape by its name", kRun},
};

}  // namespace

extern constinit const Rule sml1112_geometry_first_child_foreign{
    .id = "SML1112",
    .name = "geometry-first-child-foreign",
    .severity = Severity::error,
    .summary = "The first element of a geometry is not its shape.",
    .remedy = "Move the shape to the front.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1112_geometry_first_child_foreign_file
