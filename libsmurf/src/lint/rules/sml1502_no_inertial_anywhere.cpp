// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "readers/circumstances.hpp"
#include "readers/rigid_bodies.hpp"

namespace smurf::rules::sml1502_no_inertial_anywhere_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot || model.robot->links.empty()) return;
  for (const urdf::Link& link : model.robot->links) {
    if (link.inertial) return;
  }
  const auto movable = std::find_if(model.robot->joints.begin(), model.robot->joints.end(),
                                    [](const urdf::Joint& joint) { return joint.is_movable(); });
  if (movable == model.robot->joints.end()) return;
  const Field<std::string>& name = model.robot->name;
  Diagnostic& diagnostic =
      findings.report(name.span.empty() ? tag_name(model, model.robot->document.root) : name.span,
                      "no link of this robot has an inertial");
  diagnostic.label(name_place(model, *movable), "moving links need a mass");
  const std::vector<bool> massless = massless_bodies(model);
  if (std::find(massless.begin(), massless.end(), true) != massless.end()) {
    diagnostic.when(kMasslessBody);
  }
  diagnostic.note("Gazebo loads no link, Bullet gives each link 1 kg");
}

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::changes,
     "gives each link 1 kg, and computes its inertia from the collisions", kRun},
    {&readers::gazebo, Effect::refuses, "drops every link, and refuses a model without links",
     kRun},
    {&readers::dart, Effect::changes, "gives each link 1 kg and 1 kg m2", kRun},
    {&readers::mujoco, Effect::refuses, "refuses a moving body without mass or collision", kRun,
     when(kMasslessBody)},
    {&readers::mujoco, Effect::changes, "gives the collisions the density of water", kRun},
};

}  // namespace

extern constinit const Rule sml1502_no_inertial_anywhere{
    .id = "SML1502",
    .name = "no-inertial-anywhere",
    .severity = Severity::warning,
    .summary = "A robot with movable joints has no inertial at all.",
    .why = "Simulators need inertials; viewers and path planners do not.",
    .remedy = "Add inertials, if the robot is to be simulated.",
    .sources = "102 of 322 files of the Tola/Corke dataset.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1502_no_inertial_anywhere_file
