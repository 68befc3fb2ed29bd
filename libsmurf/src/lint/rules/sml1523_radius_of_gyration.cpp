// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "base/numbers.hpp"
#include "link/inertia.hpp"
#include "lint/body.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1523_radius_of_gyration_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  constexpr double kShortest = 1e-3;  // m
  constexpr double kLongest = 2;      // m
  for_each_link(model, [&](const urdf::Link& link) {
    if (!link.inertial || is_unit_tensor(*link.inertial)) return;
    const auto moments = principal_moments(*link.inertial);
    const double mass = link.inertial->mass.value_or(0);
    if (!moments || mass < kNegligibleMass) return;
    const double radius = std::sqrt((*moments)[2] / mass);
    if (radius >= kShortest && radius <= kLongest) return;
    // When the size of the link is known, another rule compares the inertia with it.
    if (extent_of(model, link) || !body_of(*link.inertial)) return;
    findings
        .report(inertia_place(model, *link.inertial),
                "the inertia of " + title(link) + " does not fit its mass")
        .caret =
        format_rounded(mass, 3) + " kg at " + format_rounded(radius, 2) + " m from the axis";
  });
}

}  // namespace

extern constinit const Rule sml1523_radius_of_gyration{
    .id = "SML1523",
    .name = "radius-of-gyration",
    .severity = Severity::warning,
    .summary = "An inertia belongs to a body of unlikely size.",
    .why = "The square root of inertia divided by mass is the distance of the mass from the axis: "
           "less than a millimetre or more than two metres usually means a wrong unit (kg mm2, g "
           "mm2). Joints then jitter or hardly move.",
    .remedy = "Write the inertia in kg m2.",
    .sources = "38 of 322 files of the Tola/Corke dataset.",
    .check_model = check};

}  // namespace smurf::rules::sml1523_radius_of_gyration_file
