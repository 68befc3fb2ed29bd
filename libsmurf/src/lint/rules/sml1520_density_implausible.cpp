// SPDX-License-Identifier: BSD-3-Clause
#include <variant>

#include "base/numbers/numbers.hpp"
#include "base/ranges.hpp"
#include "link/inertia.hpp"
#include "lint/body.hpp"
#include "lint/geometry_queries.hpp"
#include "lint/likely_cause.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1520_density_implausible_file {
namespace {

/// The largest shape of a link.
struct LargestShape {
  const urdf::Geometry* geometry = nullptr;
  double volume = -1;  ///< m3
};

/// At least this part of the box of an open mesh is full.
constexpr double kFullPart = 0.1;

LargestShape largest_shape(const LinkedModel& model, const urdf::Link& link) {
  LargestShape largest;
  const auto add = [&](const urdf::Geometry& geometry) {
    const std::optional<Box> box = bounding_box(model, geometry);
    if (!box) return;
    const std::optional<Solid> solid = solid_of(model, geometry);
    const Vector3 size = box->size();
    const double volume = solid ? solid->volume : kFullPart * size[0] * size[1] * size[2];
    if (volume > largest.volume) largest = {&geometry, volume};
  };
  for (const urdf::Visual& visual : link.visuals) add(visual.geometry);
  for (const urdf::Collision& collision : link.collisions) add(collision.geometry);
  return largest;
}

Cause cause_of(const LinkedModel& model, const urdf::Link& link, const Extent& extent) {
  const std::optional<Body> body = body_of(*link.inertial);
  return body ? likely_cause(model, link, *body, extent) : Cause{};
}

/// The scale of a mesh, or its name.
Span place_of_size(const LinkedModel& model, const urdf::Geometry& geometry) {
  const auto* mesh = std::get_if<urdf::Mesh>(&geometry.shape);
  if (mesh == nullptr) return tag_name(model, geometry.shape_element);
  return mesh->scale ? mesh->scale.span : mesh->filename.span;
}

/// How much larger the inertia is than this mass in these shapes allows; 0 if it is unknown.
double inertia_excess(const urdf::Link& link, const Extent& extent) {
  constexpr double kMargin = 0.1;  // of the longest edge, as in SML1518
  const std::optional<Body> body = body_of(*link.inertial);
  if (!body || is_unit_tensor(*link.inertial)) return 0;
  return excess_over(*body, extent.grown(kMargin * extent.longest_edge()));
}

/// Marks an inertia that is too large, too, which SML1518 then does not report.
void label_inertia(const LinkedModel& model, const urdf::Link& link, const Extent& extent,
                   Diagnostic& diagnostic) {
  constexpr double kSure = 2;
  const double excess = inertia_excess(link, extent);
  if (excess < kSure) return;
  diagnostic.label(inertia_place(model, *link.inertial),
                   format_rounded(excess, 2) + " times what this mass in these shapes allows");
}

bool has_mesh(const urdf::Link& link) {
  const auto is_mesh = [](const auto& part) {
    return std::holds_alternative<urdf::Mesh>(part.geometry.shape);
  };
  return ranges::any_of(link.visuals, is_mesh) || ranges::any_of(link.collisions, is_mesh);
}

/// Whether the shapes only mark a sensor or a frame, whose inertia is not larger than that of a
/// part of usual size.
bool is_marker(const urdf::Link& link, const Extent& extent) {
  constexpr double kSmall = 0.02;  // m
  constexpr double kLight = 0.1;   // kg
  constexpr double kLarge = 10;    // times
  return !has_mesh(link) && extent.longest_edge() <= kSmall && *link.inertial->mass <= kLight &&
         inertia_excess(link, extent) < kLarge;
}

void report(const LinkedModel& model, const urdf::Link& link, const Extent& extent, bool is_heavy,
            Findings& findings) {
  const LargestShape largest = largest_shape(model, link);
  const Cause cause = cause_of(model, link, extent);
  const double mass = *link.inertial->mass;
  const Span shape = place_of_size(model, *largest.geometry);
  const std::string text =
      is_heavy
          ? format_rounded(mass / extent.volume(), 2) + " kg/m3 even if it fills their bounding box"
          : format_rounded(mass / largest.volume, 2) + " kg/m3 in one of them";
  if (cause.culprit == Culprit::shape) {
    Diagnostic& diagnostic = findings.report(shape, "the shape of " + title(link) +
                                                        " does not have the size of its inertial");
    diagnostic.label(link.inertial->mass.span, text);
    diagnostic.help(cause.question);
    return;
  }
  Diagnostic& diagnostic = findings.report(link.inertial->mass.span,
                                           "the mass of " + title(link) + " is too " +
                                               (is_heavy ? "large" : "small") + " for its shapes");
  diagnostic.caret = text;
  if (!is_heavy) diagnostic.label(shape, "is this in metres?");
  if (is_heavy) label_inertia(model, link, extent, diagnostic);
  const bool is_about_mass =
      cause.culprit == Culprit::mass || cause.culprit == Culprit::mass_and_inertia;
  if (is_about_mass) diagnostic.help(cause.question);
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_link(model, [&](const urdf::Link& link) {
    const auto extent = extent_of(model, link);
    if (!extent || !link.inertial || link.inertial->mass.value_or(0) < kNegligibleMass) return;
    const double mass = *link.inertial->mass;
    const bool is_heavy = mass > kHeaviestMaterial * extent->volume();
    const bool is_light = mass < kLightestMaterial * largest_shape(model, link).volume;
    if (is_heavy && is_marker(link, *extent)) return;
    if (is_heavy || is_light) report(model, link, *extent, is_heavy, findings);
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

}  // namespace smurf::rules::sml1520_density_implausible_file
