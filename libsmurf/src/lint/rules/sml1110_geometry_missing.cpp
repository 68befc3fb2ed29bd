// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <vector>

#include "ast/urdf_schema.hpp"
#include "base/findings/readers.hpp"
#include "base/ranges.hpp"
#include "lint/geometry_queries.hpp"
#include "readers/circumstances.hpp"

namespace smurf::rules::sml1110_geometry_missing_file {
namespace {

constexpr Circumstance kDrakeShape{"shape of Drake", &readers::drake};

bool is_shape_of(const urdf::ElementSpec& spec, std::string_view name) {
  return spec.child(name) != nullptr ||
         (name != "verbose" && ranges::contains(spec.extensions, name));
}

/// Any shape that some reader knows. A misspelt shape is reported elsewhere; to readers, it is
/// missing.
bool has_shape(const LinkedModel& model, const urdf::Geometry& geometry, Findings& findings) {
  const urdf::ElementSpec& spec = *urdf::find_element_spec("geometry");
  const xml::View element(model.robot->document, geometry.element);
  for (const xml::View child : element) {
    if (is_shape_of(spec, child.name())) return true;
  }
  std::vector<std::string_view> shapes;
  for (const urdf::ChildSpec& child : spec.children) shapes.push_back(child.name);
  for (const xml::View child : element) {
    if (!urdf::meant_name(child.name(), shapes)) continue;
    findings.add_consequence(child.name_span());
    return true;
  }
  return false;
}

bool has_drake_shape(const LinkedModel& model, const urdf::Geometry& geometry) {
  if (geometry.element == xml::kNoElement) return false;
  const xml::View element(model.robot->document, geometry.element);
  return std::any_of(element.begin(), element.end(), [](const xml::View child) {
    return child.name() == "drake:capsule" || child.name() == "drake:ellipsoid";
  });
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_geometry(model, [&](const GeometryUse& use) {
    const bool is_written = use.geometry.element != xml::kNoElement;
    if (is_written && has_shape(model, use.geometry, findings)) return;
    if (!is_written && is_slip(model, use.element, "geometry", findings)) return;
    const bool is_empty = use.geometry.shape_element == xml::kNoElement;
    Diagnostic& diagnostic =
        findings.report(tag_name(model, is_written ? use.geometry.element : use.element),
                        "a " + std::string(to_string(use.role)) + " of " + title(use.link) +
                            (!is_written ? " has no geometry"
                             : is_empty  ? " has an empty geometry"
                                         : " has a geometry without a shape"));
    if (has_drake_shape(model, use.geometry)) diagnostic.when(kDrakeShape);
  });
}

constexpr Fact kFacts[] = {
    urdfdom_drops_shapes(),
    {&readers::pybullet, Effect::refuses, "refuses the whole robot", "Bullet UrdfParser.cpp, run"},
    {&readers::mujoco, Effect::refuses, "refuses a visual without geometry", kRun,
     when(kVisualsKept)},
    {&readers::mujoco, Effect::ignores, "discards visuals", "MuJoCo (discardvisual), run",
     at("visual")},
    {&readers::mujoco, Effect::refuses, "refuses a collision without geometry", kRun},
    {&readers::drake, Effect::takes, "knows the shape", kRun, when(kDrakeShape)},
    {&readers::drake, Effect::refuses, "refuses the file", kRun},
    {&readers::phobos, Effect::loses, "keeps a shape without geometry", kRun},
};

}  // namespace

extern constinit const Rule sml1110_geometry_missing{
    .id = "SML1110",
    .name = "geometry-missing",
    .severity = Severity::error,
    .summary = "A visual or collision has no geometry, or one without a shape.",
    .why = "urdf-loader crashes.",
    .remedy = "Add a shape.",
    .sources = "urdf-loader 0.13, executed.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1110_geometry_missing_file
