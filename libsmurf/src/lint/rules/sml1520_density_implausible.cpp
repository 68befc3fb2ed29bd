// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "lint/body.hpp"
#include "lint/geometry_queries.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

/// The largest shape of a link, and its volume in m^3.
struct LargestShape {
  Span place;
  double volume = -1;
};

LargestShape largest_shape(const LinkedModel& model, const urdf::Link& link) {
  LargestShape largest;
  const auto add = [&](const urdf::Geometry& geometry) {
    const std::optional<Box> box = bounding_box(model, geometry);
    if (!box) return;
    const Vector3 size = box->size();
    const double volume = size[0] * size[1] * size[2];
    if (volume > largest.volume) largest = {tag_name(model, geometry.shape_element), volume};
  };
  for (const urdf::Visual& visual : link.visuals) add(visual.geometry);
  for (const urdf::Collision& collision : link.collisions) add(collision.geometry);
  return largest;
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_link(model, [&](const urdf::Link& link) {
    const auto extent = extent_of(model, link);
    if (!extent || !link.inertial || link.inertial->mass.value_or(0) < kNegligibleMass) return;
    const double mass = *link.inertial->mass;
    const Span place = link.inertial->mass.span;
    if (mass > kHeaviestMaterial * extent->volume()) {
      findings.report(place, "the mass of " + title(link) + " is too large for its shapes").caret =
          format_rounded(mass / extent->volume(), 2) + " kg/m3 even if it fills their bounding box";
      return;
    }
    const LargestShape largest = largest_shape(model, link);
    if (mass >= kLightestMaterial * largest.volume) return;
    Diagnostic& diagnostic =
        findings.report(place, "the mass of " + title(link) + " is too small for its shapes");
    diagnostic.caret = format_rounded(mass / largest.volume, 2) + " kg/m3 in one of them";
    diagnostic.label(largest.place, "is this in metres?");
  });
}

}  // namespace

extern constinit const Rule sml1520_density_implausible{
    .id = "SML1520",
    .name = "density-implausible",
    .severity = Severity::warning,
    .summary = "The mass of a link does not fit the volume of its shapes.",
    .why =
        "No material is heavier than 22600 kg/m3 (osmium), and a part is rarely lighter than air. A mass in grams, or shapes in the wrong unit, make simulated forces wrong by a factor of a thousand.",
    .remedy = "Check the unit of the mass (kg) and of the shapes (m).",
    .sources = "Density of osmium; median of 322 files of the Tola/Corke dataset: 821 kg/m3.",
    .check_model = check};

}  // namespace smurf::rules
