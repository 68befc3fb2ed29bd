// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "lint/queries.hpp"
#include "readers/circumstances.hpp"
#include "readers/rigid_bodies.hpp"
#include "readers/sdformat_losses.hpp"

namespace smurf::rules::sml1509_mass_negative_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  const std::vector<bool> alone = alone_in_motion(model);
  InertialsTogether together(model);
  std::size_t index = 0;
  for_each_link(model, [&](const urdf::Link& link) {
    const std::size_t at = index++;
    if (!link.inertial || !link.inertial->mass || *link.inertial->mass >= 0) return;
    Diagnostic& diagnostic =
        findings.report(link.inertial->mass.span, "the mass of " + title(link) + " is " +
                                                      format_number(*link.inertial->mass) + " kg");
    if (alone[at]) diagnostic.when(kAlone);
    together.tell(at, diagnostic);
  });
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::takes, "keeps the number", kRun},
    {&readers::mars, Effect::breaks, "passes the mass to ODE, which reports it as wrong",
     "ODE dMassCheck, run"},
    {&readers::pybullet, Effect::takes, "keeps the number", kRun},
    {&readers::gazebo, Effect::changes,
     "adds it to the body that it is fixed to, or drops the link", kRun, when(kSoundTogether)},
    kGazeboLeavesOut,
    {&readers::gazebo, Effect::refuses, "reports error E18, an invalid inertia", kRun},
    {&readers::dart, Effect::changes, "warns and goes on", kRun},
    {&readers::mujoco, Effect::refuses, "refuses the mass", kRun, when(kAlone)},
    {&readers::mujoco, Effect::changes, "adds it to the body that it is fixed to", kRun},
    {&readers::drake, Effect::changes, "replaces the body by a sphere of water of 1 kg", kRun},
};

}  // namespace

extern constinit const Rule sml1509_mass_negative{.id = "SML1509",
                                                  .name = "mass-negative",
                                                  .severity = Severity::error,
                                                  .summary = "A link has a negative mass.",
                                                  .why = "No body has a negative mass.",
                                                  .remedy = "Correct the sign.",
                                                  .check_model = check,
                                                  .facts = kFacts,
                                                  .about = About::robot};

}  // namespace smurf::rules::sml1509_mass_negative_file
