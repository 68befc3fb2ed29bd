// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "base/readers.hpp"
#include "lint/geometry_queries.hpp"

namespace smurf::rules {
namespace {

constexpr std::string_view kShapes[] = {"box",     "sphere", "cylinder", "mesh",
                                        "capsule", "plane",  "cdf",      "ellipsoid"};

/// A geometry in which no reader of plain URDF finds a shape. A shape with a prefix is one to the
/// readers of that vocabulary; what is misspelt or unknown is reported where it stands.
void check_shape(const LinkedModel& model, const GeometryUse& use, Findings& findings) {
  const xml::View geometry(model.robot->document, use.geometry.element);
  xml::View prefixed;
  for (const xml::View child : geometry) {
    const std::string_view name = child.name();
    if (std::find(std::begin(kShapes), std::end(kShapes), name) != std::end(kShapes)) return;
    if (!prefixed && name.find(':') != std::string_view::npos) prefixed = child;
  }
  const xml::View first = *geometry.begin();
  if (!prefixed || first.name().starts_with("xacro:")) {
    return findings.add_consequence(first.name_span());
  }
  Diagnostic& diagnostic = findings.report(
      prefixed.name_span(), "a " + std::string(to_string(use.role)) + " of " + title(use.link) +
                                " has no shape but " + quoted(prefixed.name()));
  diagnostic.severity = Severity::warning;
  diagnostic.construct = "foreign";
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_geometry(model, [&](const GeometryUse& use) {
    if (use.geometry.shape_element != xml::kNoElement) return check_shape(model, use, findings);
    const bool is_empty = use.geometry.element != xml::kNoElement;
    if (!is_empty && is_slip(model, use.element, "geometry", findings)) return;
    findings.report(tag_name(model, is_empty ? use.geometry.element : use.element),
                    "a " + std::string(to_string(use.role)) + " of " + title(use.link) +
                        (is_empty ? " has an empty geometry" : " has no geometry"));
  });
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::breaks,
     "reports an error and drops the visuals and collisions of the link that follow",
     "urdfdom link.cpp:415-486, run"},
    {&readers::pybullet, Effect::refuses, "refuses the whole robot", "Bullet UrdfParser.cpp, run"},
    {&readers::mujoco, Effect::ignores, "discards visuals", "MuJoCo (discardvisual), run",
     "/visual/"},
    {&readers::mujoco, Effect::refuses, "refuses a collision without geometry", kRun},
    {&readers::drake, Effect::takes, "knows shapes of its own", "Drake detail_urdf_geometry.cc",
     "#foreign"},
    {&readers::drake, Effect::refuses, "refuses the file", "Drake detail_urdf_geometry.cc"},
};

}  // namespace

extern constinit const Rule sml1110_geometry_missing{
    .id = "SML1110",
    .name = "geometry-missing",
    .severity = Severity::error,
    .summary = "A visual or collision has no geometry, or an empty one.",
    .why = "urdf-loader crashes.",
    .remedy = "Add a shape.",
    .sources = "urdf-loader 0.13, executed.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules
