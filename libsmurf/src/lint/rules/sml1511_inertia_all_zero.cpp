// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "link/inertia.hpp"
#include "lint/queries.hpp"
#include "readers/circumstances.hpp"
#include "readers/rigid_bodies.hpp"

namespace smurf::rules::sml1511_inertia_all_zero_file {
namespace {

constexpr Circumstance kMoving{"moving"};

/// The first entry that urdfdom cannot read, or the tensor that lacks one. It leaves all six at 0
/// then.
std::optional<Span> find_unread(const LinkedModel& model, const urdf::Inertial& inertial) {
  for (const Field<double>* entry : entries_of(inertial)) {
    if (entry->written && !*entry) return entry->span;
    if (!entry->written) return inertia_place(model, inertial);
  }
  return std::nullopt;
}

void check(const LinkedModel& model, Findings& findings) {
  const std::vector<bool> is_carried = fixed_to_heavier(model);
  const std::vector<bool> alone = alone_in_motion(model);
  std::vector<bool> near_zero;  // computed when it is needed
  std::size_t index = 0;
  for_each_link(model, [&](const urdf::Link& link) {
    const std::size_t at = index++;
    if (!link.inertial || link.inertial->mass.value_or(0) <= 0) return;
    if (const auto place = find_unread(model, *link.inertial)) {
      if (near_zero.empty()) near_zero = near_zero_together(model);
      if (near_zero[at]) findings.add_consequence(*place);
      return;
    }
    const auto moments = principal_moments(*link.inertial);
    if (!moments || !are_zero(*moments)) return;
    Diagnostic& diagnostic =
        findings.report(inertia_place(model, *link.inertial),
                        "the inertia of " + title(link) + " is zero, but its mass is not");
    // A point mass on another body: together they have an inertia.
    if (is_carried[at]) {
      diagnostic.severity = Severity::info;
    } else {
      diagnostic.when(kMoving);
      if (alone[at]) diagnostic.when(kAlone);
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::takes, "keeps the zeros", kRun},
    {&readers::mars, Effect::breaks, "passes the inertia to ODE, which reports it as wrong",
     "ODE dMassCheck, run"},
    {&readers::phobos, Effect::takes, "keeps the numbers", kRun},
    {&readers::pybullet, Effect::ignores,
     "computes the inertia from the collisions, unless told otherwise", kRun},
    {&readers::dart, Effect::changes, "goes on with a mass matrix that is singular", kRun,
     when(kMoving)},
    kGazeboAddsZeros,
    {&readers::mujoco, Effect::refuses, "refuses a moving body without inertia", kRun,
     when(kAlone)},
    {&readers::mujoco, Effect::takes, "adds it to the body that it is fixed to", kRun},
    {&readers::drake, Effect::changes, "computes with a mass matrix that is singular", kRun,
     when(kMoving)},
};

}  // namespace

extern constinit const Rule sml1511_inertia_all_zero{
    .id = "SML1511",
    .name = "inertia-all-zero",
    .severity = Severity::error,
    .summary = "An inertia is zero although the link has a mass.",
    .why = "Other engines get a singular mass matrix.",
    .remedy = "Compute the inertia from the geometry and the mass.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml1511_inertia_all_zero_file
