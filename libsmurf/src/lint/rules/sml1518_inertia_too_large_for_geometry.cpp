// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "base/numbers/numbers.hpp"
#include "link/inertia.hpp"
#include "lint/axis_order.hpp"
#include "lint/exact_slip.hpp"
#include "lint/likely_cause.hpp"
#include "lint/model_answers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1518_inertia_too_large_for_geometry_file {
namespace {

/// Three equal moments that are a power of ten: nobody measured them, in whatever unit.
bool is_placeholder(const Body& body) {
  const auto [x, y, z] = body.second_moments;
  const double moment = x + y;
  const double exponent = std::log10(moment);
  constexpr double kRounding = 1e-9;
  return std::abs(x - y) <= kRounding * moment && std::abs(y - z) <= kRounding * moment &&
         std::abs(exponent - std::round(exponent)) <= kRounding;
}

/// Whether the same inertia about the middle of the shapes is possible: then it is not the inertia
/// that is wrong, but the centre of mass, which lies at an edge.
bool fits_middle(const Body& body, const Extent& extent, double slack) {
  Body moved = body;
  for (std::size_t i = 0; i < 3; ++i) moved.center[i] = (extent.low[i] + extent.high[i]) / 2;
  return excess_over(moved, extent) <= slack;
}

void check(const LinkedModel& model, Findings& findings) {
  constexpr double kSlack = 1.2;   // shapes are simplified
  constexpr double kLarge = 10;    // of parts so light that their numbers are often made up
  constexpr double kMargin = 0.1;  // of the longest edge
  constexpr double kSure = 2;      // a smaller excess may be that of parts without a shape
  constexpr double kFar = 5;       // if the centre of mass is outside, which SML1521 reports
  for_each_link(model, [&](const urdf::Link& link) {
    const std::optional<Extent>& extent = findings.answers().extent(link);
    const std::optional<Body>& body = findings.answers().body(link);
    if (!extent || !body) return;
    // Separate rules report the unit tensor and a wrong mass.
    if (is_unit_tensor(*link.inertial) || body->mass < kSmallestPart) return;
    if (body->mass > kHeaviestMaterial * extent->volume()) return;
    const double excess = excess_over(*body, extent->grown(kMargin * extent->longest_edge()));
    if (excess <= (body->mass <= kNegligibleMass ? kLarge : kSlack)) return;
    if (likely_axis_order(model, link, findings.answers()) != nullptr) return;  // SML1531
    if (exact_slip(link, findings.answers())) return;                           // SML1534
    const auto parts = extent_of_rigid_parts(model, link);
    if (!parts || excess_over(*body, parts->grown(kMargin * parts->longest_edge())) <= kSlack)
      return;
    const Extent around = extent->grown(kMargin * extent->longest_edge());
    if (excess < kFar && !around.contains(body->center)) return;
    Diagnostic& diagnostic =
        findings.report(inertia_place(model, *link.inertial),
                        "the inertia of " + title(link) + " is too large for its mass and shapes");
    diagnostic.caret = format_rounded(excess, 2) + " times what they allow";
    if (excess < kSure) diagnostic.severity = Severity::info;
    if (fits_middle(*body, around, kSlack)) {
      diagnostic.help(
          "is the centre of mass right? It lies at an edge of the shapes; the inertia fits one in "
          "their middle");
      return;
    }
    if (is_placeholder(*body)) {
      diagnostic.help(
          "it looks like a placeholder; compute it from the geometry and the mass, in kg m2");
      return;
    }
    const Cause cause = likely_cause(model, link, *body, *extent);
    const bool is_named =
        cause.culprit != Culprit::unknown && cause.culprit != Culprit::mass && cause.inertia <= 1;
    if (is_named) diagnostic.help(cause.question);
  });
}

}  // namespace

extern constinit const Rule sml1518_inertia_too_large_for_geometry{
    .id = "SML1518",
    .name = "inertia-too-large-for-geometry",
    .severity = Severity::warning,
    .summary = "An inertia is larger than any mass inside the shapes of the link can have.",
    .why = "The link then turns as if its mass were metres away: joints respond slowly, "
           "controllers tuned in simulation fail on the robot. Inertias in kg mm2 are a million "
           "times too large.",
    .remedy = "Compute the inertia from the geometry and the mass, in kg m2.",
    .sources = "Bhatia-Davis inequality; MuJoCo documentation on URDF; 48 of 322 files of the "
               "Tola/Corke dataset.",
    .check_model = check,
    .about = About::robot};

}  // namespace smurf::rules::sml1518_inertia_too_large_for_geometry_file
