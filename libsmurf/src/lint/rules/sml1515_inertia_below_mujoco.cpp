// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "lint/inertia.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  constexpr double kSmallest = 1e-14;     // kg m^2, mjEPS
  constexpr double kMassReported = 1e-6;  // kg; such a mass is reported instead
  for_each_link(model, [&](const urdf::Link& link) {
    if (!link.inertial || link.inertial->mass.value_or(0) <= kMassReported) return;
    const auto moments = principal_moments(*link.inertial);
    if (!moments || !is_positive_definite(*moments) || (*moments)[0] >= kSmallest) return;
    if (triangle_excess(*moments) > kImpossibleExcess) return;  // SML1513
    findings
        .report(inertia_place(model, *link.inertial),
                "the smallest moment of inertia of " + title(link) + " is " +
                    format_rounded((*moments)[0], 3) + " kg m2")
        .notes.push_back("MuJoCo refuses less than 1e-14");
  });
}

}  // namespace

extern constinit const Rule sml1515_inertia_below_mujoco{
    .id = "SML1515",
    .name = "inertia-below-mujoco",
    .severity = Severity::warning,
    .summary = "A moment of inertia is smaller than MuJoCo accepts.",
    .why = "MuJoCo compares with 1e-14 kg m2, whatever the unit or mass, and refuses the whole "
           "file.",
    .remedy = "Write the real inertia, or remove the inertial of a link that is only a frame.",
    .sources = "MuJoCo 3.14 (user_util.cc:862), executed: 176 inertials of the Tola/Corke dataset.",
    .check_model = check};

}  // namespace smurf::rules
