// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/findings/readers.hpp"
#include "base/findings/uncertain.hpp"
#include "base/numbers/numbers.hpp"
#include "base/ranges.hpp"
#include "link/inertia.hpp"
#include "link/mujoco_compiler.hpp"
#include "lint/queries.hpp"
#include "readers/circumstances.hpp"
#include "readers/rigid_bodies.hpp"
#include "readers/sdformat_losses.hpp"

namespace smurf::rules::sml1514_triangle_rounding_file {
namespace {

constexpr Circumstance kBeyondDrake{"beyond the tolerance of Drake"};
constexpr Circumstance kLost{"lost"};
constexpr Circumstance kBeyondSdformat{"beyond the tolerance of sdformat"};

constexpr double kEpsilon = 2.220446049250313e-16;

/// Marks the readers whose tolerances the excess exceeds.
void mark(double excess, double trace, Diagnostic& diagnostic) {
  const bool is_far = excess > 16 * kEpsilon * std::max(1.0, trace / 2);
  if (is_far) diagnostic.when(kBeyondDrake);
  if (is_far || excess > 10 * kEpsilon * trace / 2) diagnostic.when(kBeyondSdformat);
}

/// The entry to lower when the tensor is diagonal, as a plate's usually is.
const Field<double>* largest_of_diagonal(const urdf::Inertial& inertial) {
  if (*inertial.ixy != 0 || *inertial.ixz != 0 || *inertial.iyz != 0) return nullptr;
  const Field<double>* largest = &inertial.ixx;
  for (const Field<double>* entry : {&inertial.iyy, &inertial.izz}) {
    if (**entry > **largest) largest = entry;
  }
  return largest;
}

/// Whether something is so heavy or so far away that moments can be lost beside it.
bool has_extreme_number(const urdf::Robot& robot) {
  constexpr double kExtreme = 1e4;  // kg, m
  const auto is_far = [](const urdf::Origin& origin) {
    return ranges::any_of(origin.xyz.value_or(Vector3{}),
                          [](double value) { return std::fabs(value) > kExtreme; });
  };
  const auto is_extreme = [&](const urdf::Link& link) {
    return link.inertial &&
           (link.inertial->mass.value_or(0) > kExtreme || is_far(link.inertial->origin));
  };
  return ranges::any_of(robot.links, is_extreme) ||
         ranges::any_of(robot.joints, [&](const urdf::Joint& one) { return is_far(one.origin); });
}

/// sdformat adds up the inertials of a body about a point other than their centre. Moments smaller
/// than the rounding errors of that sum are lost.
void check_heavy(const LinkedModel& model, Findings& findings) {
  if (!model.robot || !has_extreme_number(*model.robot)) return;
  const std::vector<double> roundings = roundings_of_sdformat(model);
  std::size_t index = 0;
  for_each_link(model, [&](const urdf::Link& link) {
    const std::size_t at = index++;
    if (!link.inertial || !(roundings[at] > link.inertial->ixx.value_or(0))) return;
    const auto moments = principal_moments(*link.inertial);
    if (!moments || !is_positive_definite(*moments) || triangle_excess(*moments) > 0) return;
    findings
        .report(inertia_place(model, *link.inertial),
                "the inertia of " + title(link) + " is lost in rounding beside its mass")
        .when(kLost)
        .when(kUncertain);
  });
}

void check(const LinkedModel& model, Findings& findings) {
  check_heavy(model, findings);
  constexpr double kNoise = 1e-14;   // of the eigenvalues
  constexpr double kMargin = 1e-12;  // what the sum is lowered by, relative
  InertialsTogether together(model);
  std::size_t index = 0;
  for_each_link(model, [&](const urdf::Link& link) {
    const std::size_t at = index++;
    if (!link.inertial) return;
    const auto moments = principal_moments(*link.inertial);
    if (!moments || !is_positive_definite(*moments)) return;
    const double excess = triangle_excess(*moments);
    // The moments of a diagonal tensor are its entries, without rounding errors.
    const double noise = is_diagonal(*link.inertial) ? 0 : kNoise;
    if (excess <= noise || excess > kImpossibleExcess) return;
    Diagnostic& diagnostic = findings.report(inertia_place(model, *link.inertial),
                                             "the largest moment of " + title(link) +
                                                 " exceeds the sum of the others by rounding");
    diagnostic.caret = "too large by " + format_rounded(100 * excess, 2) + " %";
    diagnostic.note("MuJoCo refuses the file");
    const auto& [low, middle, high] = *moments;
    mark(high - (low + middle), low + middle + high, diagnostic);
    together.tell(at, diagnostic);
    const Field<double>* entry = largest_of_diagonal(*link.inertial);
    if (entry == nullptr) return;
    const std::string lowered = format_number(((*moments)[0] + (*moments)[1]) * (1 - kMargin));
    diagnostic.help("write " + lowered);
    diagnostic.fixes.push_back({Applicability::unsafe, {{entry->span, lowered}}});
  });
}

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::takes,
     "merges the link into the body it is fixed to, or drops the link", kRun, when(kSoundTogether)},
    kGazeboLeavesOut,
    {&readers::gazebo, Effect::refuses, "reports error E18, an invalid inertia",
     "gz-math MassMatrix3.hh, run", when(kBeyondSdformat)},
    {&readers::gazebo, Effect::refuses,
     "adds it to the body that it is fixed to, and may report error E18, an invalid inertia", kRun,
     when(kLost, kUncertain)},
    {&readers::mujoco, Effect::refuses,
     "adds it to the body that it is fixed to, and may refuse the sum", "4.0.0, run",
     when(kLost, kUncertain)},
    {&readers::mujoco, Effect::changes, "balances the moments, because the file tells it to", kRun,
     when(kBalanced)},
    {&readers::mujoco, Effect::refuses, "refuses the inertia: it has no tolerance",
     "MuJoCo user_objects.cc:2762-2770, run"},
    {&readers::drake, Effect::changes, "replaces the body by a sphere of water with that mass",
     kRun, when(kBeyondDrake)},
};

}  // namespace

extern constinit const Rule sml1514_triangle_rounding{
    .id = "SML1514",
    .name = "triangle-rounding",
    .severity = Severity::warning,
    .summary = "An inertia breaks the triangle inequality by rounding.",
    .why =
        "The largest moment of a flat part equals the sum of the other two; rounding to few digits "
        "can push it above.",
    .remedy = "Print more digits, or lower the largest moment by the difference.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1514_triangle_rounding_file
