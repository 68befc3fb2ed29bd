// SPDX-License-Identifier: BSD-3-Clause
#include <optional>

#include "base/numbers/numbers.hpp"
#include "lint/inertia_slips.hpp"
#include "lint/likely_cause.hpp"
#include "lint/model_answers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1519_inertia_too_small_for_geometry_file {
namespace {

/// Whether the inertia fits the visuals; then the collision is much larger than the part.
bool fits_visuals(const LinkedModel& model, const urdf::Link& link) {
  constexpr double kLeast = 0.1;  // of full shapes
  if (link.visuals.empty() || link.collisions.empty()) return false;
  const std::optional<Tensor> full = tensor_of_shapes(model, link);
  const Tensor own = tensor_of(*link.inertial);
  return full && own[0] + own[1] + own[2] > kLeast * ((*full)[0] + (*full)[1] + (*full)[2]);
}

void check(const LinkedModel& model, Findings& findings) {
  const double smallest = findings.tolerance();
  constexpr double kUnit =
      1e-4;  // of a homogeneous block: no shape explains less, a wrong unit does
  for_each_link(model, [&](const urdf::Link& link) {
    const std::optional<Extent>& extent = findings.answers().extent(link);
    const std::optional<Body>& body = findings.answers().body(link);
    if (!extent || !body || body->mass < kNegligibleMass) return;
    const double ratio = ratio_to_block(*body, *extent);
    const double density = body->mass / extent->volume();  // unlikely ones are SML1520
    if (ratio >= smallest || density < kLightestMaterial || density > kHeaviestMaterial) return;
    if (fits_visuals(model, link)) return;
    Diagnostic& diagnostic =
        findings.report(inertia_place(model, *link.inertial),
                        "the inertia of " + title(link) + " is very small for its mass and shapes");
    diagnostic.caret = format_rounded(100 * ratio, 2) + " % of a full block of that size";
    if (ratio < kUnit) diagnostic.severity = Severity::warning;
    const Cause cause = likely_cause(model, link, *body, *extent);
    const bool is_named =
        cause.culprit != Culprit::unknown && cause.culprit != Culprit::mass && cause.inertia >= 1;
    if (is_named) diagnostic.help(cause.question);
  });
}

}  // namespace

extern constinit const Rule sml1519_inertia_too_small_for_geometry{
    .id = "SML1519",
    .name = "inertia-too-small-for-geometry",
    .severity = Severity::info,
    .summary = "An inertia is far smaller than the shapes of the link suggest.",
    .why =
        "The link then turns as if its mass sat in one point: the simulation jitters or needs tiny "
        "steps, and controllers that work there fail on the robot. Inertias written for g and mm "
        "are 1e-9 of the value in kg m2.",
    .remedy = "Compute the inertia from the geometry and the mass, in kg m2.",
    .sources =
        "Distribution over 5512 inertials of the Tola/Corke dataset: half lie between 0.9 and 1.7 "
        "of the box around the link.",
    .check_model = check,
    .tolerance = {.value = 0.01,
                  .meaning = "the smallest inertia, as a fraction of that of a homogeneous block"},
    .about = About::robot};

}  // namespace smurf::rules::sml1519_inertia_too_small_for_geometry_file
