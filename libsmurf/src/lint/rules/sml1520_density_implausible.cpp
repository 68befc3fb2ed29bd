// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "lint/body.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_link(model, [&](const urdf::Link& link) {
    const auto extent = extent_of(model, link);
    if (!extent || !link.inertial || link.inertial->mass.value_or(0) < kNegligibleMass) return;
    const double density = *link.inertial->mass / extent->volume();
    if (density <= kHeaviestMaterial) return;
    findings
        .report(link.inertial->mass.span,
                "the mass of " + title(link) + " is too large for its shapes")
        .caret = format_rounded(density, 2) + " kg/m3 even if it fills their box";
  });
}

}  // namespace

extern constinit const Rule sml1520_density_implausible{
    .id = "SML1520",
    .name = "density-implausible",
    .severity = Severity::warning,
    .summary = "The mass of a link does not fit the space of its shapes.",
    .why = "No material is heavier than 22600 kg/m3 (osmium): a mass in grams, or shapes in the "
           "wrong unit, make forces and times of a simulation wrong by a factor of a thousand.",
    .remedy = "Check the unit of the mass (kg) and of the shapes (m).",
    .sources = "Density of osmium; median of 322 files of the Tola/Corke dataset: 821 kg/m3.",
    .check_model = check};

}  // namespace smurf::rules
