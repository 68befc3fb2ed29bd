// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "lint/inertia.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

constexpr double kMujocoMoment = 1e-14;  // kg m2; mjEPS, user_util.cc:862

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
    check_moments(model, link, findings);
  });
}

}  // namespace

extern constinit const Rule sml1913_inertial_too_small{
    .id = "SML1913",
    .name = "inertial-too-small",
    .severity = Severity::error,
    .summary = "An inertia is so small that a target refuses it.",
    .why = "MuJoCo refuses principal moments below 1e-14 kg m2.",
    .remedy = "Give the link an inertia that its size could have, or fix it to a heavier one.",
    .sources = "MuJoCo user_util.cc:862, executed: 176 of 5512 inertials of the Tola/Corke dataset "
               "are refused for this alone.",
    .check_model = check,
    .needs_target = true};

}  // namespace smurf::rules
