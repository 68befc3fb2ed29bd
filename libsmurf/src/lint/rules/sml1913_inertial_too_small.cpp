// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "lint/inertia.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

constexpr double kSdformatMass = 1e-6;    // kg; sdformat 12 takes no more for no mass
constexpr double kMujocoMoment = 1e-14;   // kg m2; mjEPS, user_util.cc:862
constexpr double kMujocoMinimum = 1e-15;  // kg or kg m2; mjMINVAL

void check_mass(const urdf::Link& link, Findings& findings) {
  const Field<double>& mass = link.inertial->mass;
  if (!mass || *mass <= 0 || *mass > kSdformatMass) return;
  Diagnostic& diagnostic = findings.report(mass.span, "the mass of " + title(link) + " is " +
                                                          format_rounded(*mass) + " kg");
  diagnostic.construct = *mass < kMujocoMinimum ? "mass#below-1e-15" : "mass";
}

void check_moments(const LinkedModel& model, const urdf::Link& link, Findings& findings) {
  const auto moments = principal_moments(*link.inertial);
  if (!moments || !is_positive_definite(*moments) || (*moments)[0] >= kMujocoMoment) return;
  findings
      .report(inertia_place(model, *link.inertial), "the smallest principal moment of " +
                                                        title(link) + " is " +
                                                        format_rounded((*moments)[0]) + " kg m2")
      .construct = "moment";
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_link(model, [&](const urdf::Link& link) {
    if (!link.inertial) return;
    check_mass(link, findings);
    check_moments(model, link, findings);
  });
}

}  // namespace

extern constinit const Rule sml1913_inertial_too_small{
    .id = "SML1913",
    .name = "inertial-too-small",
    .severity = Severity::error,
    .summary = "A mass or inertia is so small that a target takes it for none.",
    .why =
        "sdformat up to 12 drops a link of at most 1e-6 kg like one without mass. MuJoCo refuses "
        "principal moments below 1e-14 kg m2 and masses below 1e-15 kg.",
    .remedy = "Give the link a mass and inertia that its size could have, or fix it to a heavier "
              "one.",
    .sources =
        "sdformat 12.3, executed (sdformat issue 199); MuJoCo user_util.cc:862, executed: 176 "
        "of 5512 inertials of the Tola/Corke dataset are refused for this alone.",
    .check_model = check,
    .needs_target = true};

}  // namespace smurf::rules
