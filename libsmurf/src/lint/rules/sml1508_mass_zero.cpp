// SPDX-License-Identifier: BSD-3-Clause
#include <set>
#include <vector>

#include "base/findings/readers.hpp"
#include "base/ranges.hpp"
#include "link/inertia.hpp"
#include "lint/queries.hpp"
#include "readers/circumstances.hpp"
#include "readers/rigid_bodies.hpp"
#include "readers/sdformat_losses.hpp"

namespace smurf::rules::sml1508_mass_zero_file {
namespace {

constexpr Circumstance kMerged{"merged"};
constexpr Circumstance kRoot{"root"};

constexpr double kDropped = 1e-6;  // kg; sdformat drops bodies up to this

bool is_world(const urdf::Link& link) { return link.name.value_or("") == "world"; }

bool is_root(const LinkedModel& model, const urdf::Link& link) {
  return !is_world(link) && model.tree.roots.size() == 1 &&
         &model.link(model.tree.roots.front()) == &link;
}

bool weighs_nothing(const urdf::Link& link) {
  return link.inertial && link.inertial->mass && *link.inertial->mass == 0;
}

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot || !ranges::any_of(model.robot->links, weighs_nothing)) return;
  const std::vector<bool> massless = massless_bodies(model);
  const std::vector<bool> is_carried = fixed_to_heavier(model);
  const std::vector<double> together = masses_of_bodies(model);
  const bool is_empty = is_left_without_links(model);
  std::set<const urdf::Link*> told;  // by SML1454
  for (const MasslessSum& sum : massless_sums_of_sdformat(model))
    told.insert(&model.link(sum.link));
  std::size_t index = 0;
  for_each_link(model, [&](const urdf::Link& link) {
    const bool is_massless_body = massless[index];
    const bool has_mass = together[index] > kDropped;
    const bool is_frame = is_carried[index++];
    if (!weighs_nothing(link)) return;
    if (told.contains(&link)) return findings.add_consequence(link.inertial->mass.span);
    Diagnostic& diagnostic =
        findings.report(link.inertial->mass.span, "the mass of " + title(link) + " is 0");
    diagnostic.help("write the mass, or remove the `inertial` of a link that is only a frame");
    if (is_massless_body) diagnostic.when(kMasslessBody);
    if (has_mass) diagnostic.when(kMerged);
    if (!has_mass && (is_root(model, link) || is_empty)) diagnostic.when(kRoot);
    // Authors set mass and inertia of frames to zero on purpose, for Bullet.
    const auto moments = principal_moments(*link.inertial);
    const bool is_zero = moments && (*moments)[2] == 0;
    if (is_zero || is_frame) diagnostic.severity = Severity::warning;
    if (is_zero && is_frame) diagnostic.severity = Severity::info;
  });
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::takes, "keeps the mass 0", kRun},
    {&readers::mars, Effect::changes, "gives the link 1e-6 kg, and 1 g for each collision",
     "MARS smurf.cpp:719"},
    {&readers::pybullet, Effect::changes, "fixes a base without mass to the world", kRun},
    {&readers::gazebo, Effect::takes, "does not look at the mass of the world", kRun,
     when(kOfWorld)},
    {&readers::gazebo, Effect::takes, "adds it to the body that it is fixed to", kRun,
     when(kMerged)},
    {&readers::gazebo, Effect::refuses,
     "drops the root with everything below it: a model without links", kRun, when(kRoot)},
    {&readers::gazebo, Effect::loses, "drops the link with everything below it",
     "sdformat parser_urdf.cc:2669-2779, run"},
    {&readers::dart, Effect::changes, "warns and goes on with a mass matrix that is singular",
     kRun},
    {&readers::mujoco, Effect::refuses, "refuses a moving body without mass", kRun,
     when(kMasslessBody)},
    {&readers::mujoco, Effect::takes, "adds it to the body it is fixed to",
     "MuJoCo (fusestatic), run"},
    {&readers::drake, Effect::changes,
     "accepts a body without mass and inertia; replaces one with an inertia by a sphere of 1 kg",
     kRun},
};

}  // namespace

extern constinit const Rule sml1508_mass_zero{
    .id = "SML1508",
    .name = "mass-zero",
    .severity = Severity::error,
    .summary = "A link has an inertial with mass 0.",
    .remedy = "Write the mass, or remove the inertial of a link that is only a frame.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml1508_mass_zero_file
