// SPDX-License-Identifier: BSD-3-Clause
#include "lint/inertia.hpp"
#include "lint/queries.hpp"
#include "lint/rigid_bodies.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  const std::vector<bool> is_carried = fixed_to_heavier(model);
  std::size_t index = 0;
  for_each_link(model, [&](const urdf::Link& link) {
    const bool is_frame = is_carried[index++];
    if (!link.inertial || link.inertial->mass.value_or(0) <= 0) return;
    const auto moments = principal_moments(*link.inertial);
    if (!moments || (*moments)[0] != 0 || (*moments)[2] != 0) return;
    Diagnostic& diagnostic =
        findings.report(inertia_place(model, *link.inertial),
                        "the inertia of " + title(link) + " is zero, its mass is not");
    // A point mass on another body: together they have an inertia.
    if (is_frame) {
      diagnostic.severity = Severity::info;
    } else {
      diagnostic.construct = link.collisions.empty() ? "moving#without-collision" : "moving";
    }
  });
}

}  // namespace

extern constinit const Rule sml1511_inertia_all_zero{
    .id = "SML1511",
    .name = "inertia-all-zero",
    .severity = Severity::error,
    .summary = "An inertia is zero although the link has a mass.",
    .why = "MuJoCo refuses a moving link, ODE (MARS) refuses the mass, other engines get a "
           "singular mass matrix.",
    .remedy = "Compute the inertia from the geometry and the mass.",
    .sources = "MuJoCo 3.14 and ODE 0.16.2, executed.",
    .check_model = check};

}  // namespace smurf::rules
