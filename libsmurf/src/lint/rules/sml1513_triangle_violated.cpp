// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "link/inertia.hpp"
#include "link/mujoco_compiler.hpp"
#include "lint/inertia_slips.hpp"
#include "lint/queries.hpp"
#include "readers/circumstances.hpp"
#include "readers/rigid_bodies.hpp"
#include "readers/sdformat_losses.hpp"

namespace smurf::rules::sml1513_triangle_violated_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  InertialsTogether together(model);
  const bool are_balanced = balances_inertias(model);  // the file is written for MuJoCo
  std::size_t index = 0;
  for_each_link(model, [&](const urdf::Link& link) {
    const std::size_t at = index++;
    if (!link.inertial) return;
    const auto moments = principal_moments(*link.inertial);
    if (!moments) return;
    const auto& [low, middle, high] = *moments;
    if (!is_positive_definite(*moments) || triangle_excess(*moments) <= kImpossibleExcess) return;
    Diagnostic& diagnostic =
        findings.report(inertia_place(model, *link.inertial),
                        "the inertia of " + title(link) + " is not physically possible");
    together.tell(at, diagnostic);
    if (are_balanced) diagnostic.severity = Severity::warning;
    diagnostic.caret = "principal moments " + format_rounded(low, 4) + ", " +
                       format_rounded(middle, 4) + ", " + format_rounded(high, 4) + ": " +
                       format_rounded(high, 4) + " > " + format_rounded(low, 4) + " + " +
                       format_rounded(middle, 4);
    diagnostic.note("the largest moment can be at most the sum of the other two");
    add_likely_slip(model, link, diagnostic);
  });
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::takes, "keeps the numbers", kRun},
    {&readers::mars, Effect::changes, "computes with it anyway", "ODE dMassCheck, run"},
    {&readers::pybullet, Effect::ignores,
     "computes the inertia from the collisions, unless told otherwise", kRun},
    {&readers::gazebo, Effect::takes,
     "merges the link into the body it is fixed to, or drops the link", kRun, when(kSoundTogether)},
    kGazeboLeavesOut,
    {&readers::gazebo, Effect::refuses, "reports error E18, an invalid inertia", kRun},
    {&readers::dart, Effect::changes, "computes with it anyway", kRun},
    {&readers::mujoco, Effect::changes, "balances the moments, because the file tells it to", kRun,
     when(kBalanced)},
    {&readers::mujoco, Effect::refuses, "refuses the inertia",
     "MuJoCo user_objects.cc:2762-2770, run"},
    {&readers::drake, Effect::changes, "replaces the body by a sphere of water with that mass",
     kRun},
    {&readers::phobos, Effect::takes, "keeps the numbers", kRun},
    {&readers::pinocchio, Effect::changes, "computes with it anyway", kRun},
};

}  // namespace

extern constinit const Rule sml1513_triangle_violated{
    .id = "SML1513",
    .name = "triangle-violated",
    .severity = Severity::error,
    .summary = "The principal moments of an inertia break the triangle inequality.",
    .why = "No mass distribution has such moments.",
    .remedy = "Compute the inertia again, e.g. from the geometry and the mass.",
    .sources = "62 links of the Tola/Corke dataset, all above 1 %.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml1513_triangle_violated_file
