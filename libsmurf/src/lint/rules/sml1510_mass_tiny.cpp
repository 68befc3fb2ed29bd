// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "base/ranges.hpp"
#include "link/inertia.hpp"
#include "lint/queries.hpp"
#include "readers/circumstances.hpp"
#include "readers/rigid_bodies.hpp"

namespace smurf::rules::sml1510_mass_tiny_file {
namespace {

constexpr Circumstance kNotRootTooSmall{"mass below 1e-15 kg"};
constexpr Circumstance kMomentTooSmall{"moment below 1e-14 kg m2"};
constexpr Circumstance kNotRoot{"not the root"};
constexpr Circumstance kRoot{"root"};

bool is_world(const urdf::Link& link) { return link.name.value_or("") == "world"; }

bool is_root(const LinkedModel& model, const urdf::Link& link) {
  return !is_world(link) && model.tree.roots.size() == 1 &&
         &model.link(model.tree.roots.front()) == &link;
}

constexpr double kDropped = 1e-6;  // kg

bool is_tiny(const urdf::Link& link) {
  const double mass = link.inertial ? link.inertial->mass.value_or(0) : 0;
  return mass > 0 && mass <= kDropped;
}

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot || !ranges::any_of(model.robot->links, is_tiny)) return;
  constexpr double kMujocoMinimum = 1e-15;  // kg; mjMINVAL
  constexpr double kMujocoMoment = 1e-14;   // kg m^2; mjEPS
  const std::vector<bool> is_carried = fixed_to_heavier(model);
  const std::vector<bool> alone = alone_in_motion(model);
  const std::vector<double> together = masses_of_bodies(model);
  const bool is_empty = is_left_without_links(model);
  std::size_t index = 0;
  for_each_link(model, [&](const urdf::Link& link) {
    const bool is_alone = alone[index];
    const bool is_dropped = together[index] <= kDropped;
    const bool is_frame = is_carried[index++];
    if (!is_tiny(link)) return;
    const double mass = *link.inertial->mass;
    Diagnostic& diagnostic = findings.report(
        link.inertial->mass.span, title(link) + " weighs " + format_rounded(mass, 3) + " kg");
    // MuJoCo checks every tensor, but only the mass of whole bodies.
    const auto moments = principal_moments(*link.inertial);
    const bool is_too_small = moments && (*moments)[0] > 0 && (*moments)[0] < kMujocoMoment;
    if (is_frame) {
      if (is_too_small) diagnostic.when(kMomentTooSmall);
      diagnostic.severity = Severity::info;
      return;
    }
    if (is_dropped) {
      diagnostic.note("sdformat (Gazebo) up to 12 drops such a link and all below it");
    }
    if (is_dropped) diagnostic.when(is_root(model, link) || is_empty ? kRoot : kNotRoot);
    if (is_alone && mass < kMujocoMinimum) diagnostic.when(kNotRootTooSmall);
    if (is_too_small) diagnostic.when(kMomentTooSmall);
  });
}

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::takes, "does not look at the mass of the world", kRun,
     when(kOfWorld)},
    {&readers::gazebo, Effect::refuses,
     "drops the root with everything below it: a model without links", kRun, when(kRoot)},
    {&readers::gazebo, Effect::loses, "drops the link with everything below it",
     "sdformat, run (issue 199)", when(kNotRoot)},
    {&readers::mujoco, Effect::refuses, "refuses a mass below 1e-15 kg", "MuJoCo mjtype.h:27, run",
     when(kNotRootTooSmall)},
    {&readers::mujoco, Effect::takes, "looks at the whole body that moves", "3.1.2, run",
     when(kMomentTooSmall).unless(kAlone).before({3, 1, 3})},
    {&readers::mujoco, Effect::refuses, "refuses a principal moment below 1e-14 kg m2",
     "MuJoCo user_util.cc:862, run", when(kMomentTooSmall)},
};

}  // namespace

extern constinit const Rule sml1510_mass_tiny{
    .id = "SML1510",
    .name = "mass-tiny",
    .severity = Severity::warning,
    .summary = "A mass is so small that it is dropped, or spoils the solver.",
    .why = "Links lighter than a gram beside heavy ones make the mass matrix ill-conditioned.",
    .remedy = "Write the real mass, or delete the inertial of a link that is only a frame.",
    .sources = "34 of 322 files of the Tola/Corke dataset.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml1510_mass_tiny_file
