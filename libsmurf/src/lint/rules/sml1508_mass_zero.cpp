// SPDX-License-Identifier: BSD-3-Clause
#include "lint/inertia.hpp"
#include "lint/queries.hpp"
#include "lint/rigid_bodies.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  const std::vector<bool> massless = massless_bodies(model);
  const std::vector<bool> is_carried = fixed_to_heavier(model);
  std::size_t index = 0;
  for_each_link(model, [&](const urdf::Link& link) {
    const bool is_massless_body = massless[index];
    const bool is_frame = is_carried[index++];
    if (!link.inertial || !link.inertial->mass || *link.inertial->mass != 0) return;
    Diagnostic& diagnostic =
        findings.report(link.inertial->mass.span, "the mass of " + title(link) + " is 0");
    diagnostic.help = "write the mass, or remove the `inertial` of a link that is only a frame";
    if (is_massless_body) diagnostic.construct = "massless-body";
    // Mass and inertia both zero: how frames are written on purpose for Bullet.
    const auto moments = principal_moments(*link.inertial);
    const bool is_zero = moments && (*moments)[2] == 0;
    if (is_zero || is_frame) diagnostic.severity = Severity::warning;
    if (is_zero && is_frame) diagnostic.severity = Severity::info;
  });
}

}  // namespace

extern constinit const Rule sml1508_mass_zero{
    .id = "SML1508",
    .name = "mass-zero",
    .severity = Severity::error,
    .summary = "A link has an inertial with mass 0.",
    .why = "sdformat drops the link with everything below it, MuJoCo refuses a moving one, ODE "
           "(MARS) refuses the mass, Bullet fixes the base to the world.",
    .remedy = "Write the mass, or remove the inertial of a link that is only a frame.",
    .sources = "sdformat 12.3, MuJoCo 3.14, Bullet and ODE 0.16.2, executed.",
    .check_model = check};

}  // namespace smurf::rules
