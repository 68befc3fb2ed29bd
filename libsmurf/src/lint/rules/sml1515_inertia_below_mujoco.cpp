// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "base/readers.hpp"
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

constexpr Fact kFacts[] = {
    {&readers::mujoco, Effect::refuses, "refuses a principal moment below 1e-14 kg m2",
     "MuJoCo user_util.cc:862, run"},
};

}  // namespace

extern constinit const Rule sml1515_inertia_below_mujoco{
    .id = "SML1515",
    .name = "inertia-below-mujoco",
    .severity = Severity::warning,
    .summary = "A moment of inertia is smaller than MuJoCo accepts.",
    .remedy = "Write the real inertia, or remove the inertial of a link that is only a frame.",
    .sources = "176 inertials of the Tola/Corke dataset.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules
