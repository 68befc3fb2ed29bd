// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <set>
#include <utility>
#include <variant>
#include <vector>

#include "base/numbers/numbers.hpp"
#include "base/ranges.hpp"
#include "link/inertia.hpp"
#include "link/shape_hulls.hpp"
#include "lint/body.hpp"
#include "lint/geometry_queries.hpp"
#include "lint/likely_cause.hpp"
#include "lint/model_answers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1520_density_implausible_file {
namespace {

/// The largest shape of a link.
struct LargestShape {
  const urdf::Geometry* geometry = nullptr;
  double volume = -1;  ///< m3
};

/// Whether a collision repeats the visual.
bool are_same(const urdf::Visual& visual, const urdf::Collision& collision) {
  const auto* one = std::get_if<urdf::Mesh>(&visual.geometry.shape);
  const auto* other = std::get_if<urdf::Mesh>(&collision.geometry.shape);
  return one != nullptr && other != nullptr &&
         one->filename.value_or("") == other->filename.value_or("") &&
         one->scale.value_or({1, 1, 1}) == other->scale.value_or({1, 1, 1}) &&
         urdf::to_pose(visual.origin) == urdf::to_pose(collision.origin);
}

/// The volume around all shapes of a link: of their hull if there is one shape, else of their box.
double volume_around(const LinkedModel& model, const urdf::Link& link, const Extent& extent) {
  const bool is_one = link.visuals.size() + link.collisions.size() == 1 ||
                      (link.visuals.size() == 1 && link.collisions.size() == 1 &&
                       are_same(link.visuals.front(), link.collisions.front()));
  if (!is_one) return extent.volume();
  const urdf::Geometry& geometry =
      link.visuals.empty() ? link.collisions.front().geometry : link.visuals.front().geometry;
  if (!std::holds_alternative<urdf::Mesh>(geometry.shape)) return extent.volume();
  const auto hull = hull_of(model, geometry);
  return hull ? hull->volume : extent.volume();
}

/// Links whose density is far below that of all others of the robot.
std::vector<const urdf::Link*> light_links(const LinkedModel& model) {
  constexpr std::size_t kFewest = 4;
  constexpr double kFactor = 100;
  constexpr double kFoam = 20;  // kg/m3
  std::vector<std::pair<double, const urdf::Link*>> densities;
  for_each_link(model, [&](const urdf::Link& link) {
    if (!link.inertial || link.inertial->mass.value_or(0) < kSmallestPart) return;
    if (!extent_of(model, link)) return;
    const auto solid = solid_of(model, link);
    if (solid) densities.emplace_back(*link.inertial->mass / solid->volume, &link);
  });
  std::sort(densities.begin(), densities.end());
  std::vector<const urdf::Link*> light;
  if (densities.size() < kFewest) return light;
  // A gap of the factor above at most a quarter of the links, and none that is as wide behind it.
  for (std::size_t i = 0; i < densities.size() / 4; ++i) {
    light.push_back(densities[i].second);
    const bool is_gap = densities[i + 1].first > kFactor * densities[i].first;
    if (is_gap && densities[i].first < kFoam) return light;
  }
  return {};
}

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
  const std::string text = is_heavy
                               ? format_rounded(mass / volume_around(model, link, extent), 2) +
                                     " kg/m3 even if it fills what is around them"
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
  std::set<const urdf::Link*> reported;
  for_each_link(model, [&](const urdf::Link& link) {
    const std::optional<Extent>& extent = findings.answers().extent(link);
    if (!extent || !link.inertial || link.inertial->mass.value_or(0) < kNegligibleMass) return;
    const double mass = *link.inertial->mass;
    // The hull of what may be a sample of the points of a mesh is a little too small.
    constexpr double kSure = 2;
    const bool is_heavy = mass > kHeaviestMaterial * extent->volume() ||
                          mass > kSure * kHeaviestMaterial * volume_around(model, link, *extent);
    const bool is_light = mass < kLightestMaterial * largest_shape(model, link).volume;
    if (is_heavy && is_marker(link, *extent)) return;
    if (is_heavy || is_light) {
      report(model, link, *extent, is_heavy, findings);
      reported.insert(&link);
    }
  });
  for (const urdf::Link* link : light_links(model)) {
    if (reported.contains(link)) continue;
    const LargestShape largest = largest_shape(model, *link);
    findings
        .report(link->inertial->mass.span,
                "the mass of " + title(*link) + " is too small for its shapes")
        .label(place_of_size(model, *largest.geometry), "is this in metres?")
        .help("compare it with the other links, which have more than 100 times its density");
  }
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
    .check_model = check,
    .about = About::robot};

}  // namespace smurf::rules::sml1520_density_implausible_file
