// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "lint/body.hpp"
#include "lint/geometry_queries.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

/// The shape of a link that takes the most space.
Span largest_shape(const LinkedModel& model, const urdf::Link& link) {
  Span place;
  double most = -1;
  const auto add = [&](const urdf::Geometry& geometry) {
    const std::optional<Box> box = bounding_box(model, geometry);
    if (!box) return;
    const Vector3 size = box->size();
    const double volume = size[0] * size[1] * size[2];
    if (volume <= most) return;
    most = volume;
    place = tag_name(model, geometry.shape_element);
  };
  for (const urdf::Visual& visual : link.visuals) add(visual.geometry);
  for (const urdf::Collision& collision : link.collisions) add(collision.geometry);
  return place;
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_link(model, [&](const urdf::Link& link) {
    const auto extent = extent_of(model, link);
    if (!extent || !link.inertial || link.inertial->mass.value_or(0) < kNegligibleMass) return;
    const double density = *link.inertial->mass / extent->volume();
    if (density >= kLightestMaterial && density <= kHeaviestMaterial) return;
    const bool is_heavy = density > kHeaviestMaterial;
    Diagnostic& diagnostic = findings.report(
        link.inertial->mass.span, "the mass of " + title(link) + " is too " +
                                      (is_heavy ? "large" : "small") + " for its shapes");
    diagnostic.caret = format_rounded(density, 2) + " kg/m3 " +
                       (is_heavy ? "even if it fills their box" : "in the box around them");
    if (is_heavy) return;
    diagnostic.labels.push_back({largest_shape(model, link), "is this in metres?"});
  });
}

}  // namespace

extern constinit const Rule sml1520_density_implausible{
    .id = "SML1520",
    .name = "density-implausible",
    .severity = Severity::warning,
    .summary = "The mass of a link does not fit the space of its shapes.",
    .why =
        "No material is heavier than 22600 kg/m3 (osmium), nothing fills a hundredth of what air "
        "would: a mass in grams, or shapes in the wrong unit, make forces and times of a simulation wrong by a factor of a thousand.",
    .remedy = "Check the unit of the mass (kg) and of the shapes (m).",
    .sources = "Density of osmium; median of 322 files of the Tola/Corke dataset: 821 kg/m3.",
    .check_model = check};

}  // namespace smurf::rules
