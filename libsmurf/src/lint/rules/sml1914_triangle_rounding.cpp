// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "base/numbers.hpp"
#include "lint/inertia.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

constexpr double kEpsilon = 2.220446049250313e-16;
constexpr double kImpossible = 1e-2;  // above it SML1513 speaks

/// Which readers' tolerances the excess is beyond, as a construct; empty when within all.
std::string beyond(double excess, double trace) {
  if (excess > 16 * kEpsilon * std::max(1.0, trace / 2)) return "mujoco#sdformat#drake";
  if (excess > 10 * kEpsilon * trace / 2) return "mujoco#sdformat";
  return "mujoco";
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_link(model, [&](const urdf::Link& link) {
    if (!link.inertial) return;
    const auto moments = principal_moments(*link.inertial);
    if (!moments || !is_positive_definite(*moments)) return;
    const auto& [low, middle, high] = *moments;
    const double excess = high - (low + middle);
    // The principal moments themselves are known to a few units in the last place only.
    if (excess <= 4 * kEpsilon * high || excess / high > kImpossible) return;
    Diagnostic& diagnostic =
        findings.report(inertia_place(model, *link.inertial),
                        "rounding leaves the inertia of " + title(link) + " just impossible");
    diagnostic.caret =
        "the largest moment is " + format_rounded(excess, 2) + " kg m2 above the sum of the others";
    diagnostic.construct = beyond(excess, low + middle + high);
  });
}

}  // namespace

extern constinit const Rule sml1914_triangle_rounding{
    .id = "SML1914",
    .name = "triangle-rounding",
    .severity = Severity::error,
    .summary = "Rounded moments break the triangle inequality by less than 1 %.",
    .why =
        "The largest moment of a flat part is the sum of the other two; cut to a few digits, half "
        "of such inertias are impossible by a hair. MuJoCo tolerates nothing, sdformat 10 and "
        "Drake 16 units in the last place.",
    .remedy = "Write more digits, or make the largest moment a little smaller.",
    .sources =
        "MuJoCo user_objects.cc:2762-2770, executed; gz-math MassMatrix3.hh, executed; Drake "
        "rotational_inertia.cc:184-216.",
    .check_model = check,
    .needs_target = true};

}  // namespace smurf::rules
