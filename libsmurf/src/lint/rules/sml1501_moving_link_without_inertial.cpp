// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "readers/circumstances.hpp"
#include "readers/rigid_bodies.hpp"

namespace smurf::rules::sml1501_moving_link_without_inertial_file {
namespace {

bool is_shape_only(const LinkedModel& model) {
  for (const urdf::Link& link : model.robot->links) {
    if (link.inertial) return false;
  }
  return true;
}

void check(const LinkedModel& model, Findings& findings) {
  // A robot without any inertial is a drawing: SML1502 reports it once.
  if (!model.robot || is_shape_only(model)) return;
  const std::vector<bool> massless = massless_bodies(model);
  for (const LinkIndex link : model.tree.order) {
    const auto above = model.tree.parent_joint[to_size(link)];
    if (!above || !model.joint(*above).is_movable() || has_fixed_mass(model, link)) continue;
    Diagnostic& diagnostic = findings.report(name_place(model, model.link(link)),
                                             title(model.link(link)) + " moves and has no mass");
    if (massless[to_size(link)]) diagnostic.when(kMasslessBody);
    diagnostic.label(name_place(model, model.joint(*above)), "moved by this joint");
  }
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::takes, "keeps a link without mass", kRun},
    {&readers::mars, Effect::changes, "gives the link 1e-6 kg, and 1 g for each collision",
     "MARS smurf.cpp:719"},
    {&readers::pybullet, Effect::changes,
     "gives the link 1 kg, and computes its inertia from the collisions", kRun},
    {&readers::gazebo, Effect::loses, "drops the link with everything below it",
     "sdformat parser_urdf.cc:2669-2779, run"},
    {&readers::dart, Effect::changes, "gives the link 1 kg and an inertia of 1 kg m2", kRun},
    {&readers::mujoco, Effect::refuses, "refuses a moving body without mass or collision", kRun,
     when(kMasslessBody)},
    {&readers::mujoco, Effect::changes, "gives the collisions the density of water", kRun},
    {&readers::drake, Effect::changes, "computes with a mass matrix that is singular", kRun},
    {&readers::pinocchio, Effect::changes, "computes with a mass matrix that is singular", kRun},
};

}  // namespace

extern constinit const Rule sml1501_moving_link_without_inertial{
    .id = "SML1501",
    .name = "moving-link-without-inertial",
    .severity = Severity::error,
    .summary = "A moving link has no mass, and no link fixed to it has one.",
    .why = "Dynamics need the mass of what moves.",
    .remedy = "Add an inertial.",
    .sources = "106 of 322 files of the Tola/Corke dataset.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1501_moving_link_without_inertial_file
