// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml3240_mass_of_collisions_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  constexpr double kOfCollision = 0.001;  // kg
  const double noticeable = findings.tolerance();
  if (!model.has_main) return;
  for_each_link(model, [&](const urdf::Link& link) {
    if (!link.inertial || !link.inertial->mass || *link.inertial->mass <= 0) return;
    const double added = kOfCollision * static_cast<double>(link.collisions.size());
    const double mass = *link.inertial->mass;
    if (added <= noticeable * mass) return;
    findings.report(link.inertial->mass.span, "in MARS " + title(link) + " weighs " +
                                                  format_rounded(mass + added) +
                                                  " kg: one gram more for each collision");
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "adds one gram for each collision of a link, and a milligram for its frame",
     "MARS smurf.cpp:719, NodeData defaults"},
};

}  // namespace

extern constinit const Rule sml3240_mass_of_collisions{
    .id = "SML3240",
    .name = "mass-of-collisions",
    .severity = Severity::info,
    .summary = "MARS makes a light link much heavier than the URDF says.",
    .why = "A link of a few grams, or one with many collisions, gets a wrong mass and inertia.",
    .remedy = "Set `mass: 0.0001` for its collisions under `collision`, or merge them.",
    .check_model = check,
    .tolerance = {.value = 0.1,
                  .meaning = "the largest added mass, as a fraction of the mass of "
                             "the link"},
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml3240_mass_of_collisions_file
