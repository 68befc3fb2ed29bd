// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1505_inertia_missing_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_link(model, [&](const urdf::Link& link) {
    if (!link.inertial) return;
    const xml::View inertial(model.robot->document, link.inertial->element);
    // Misspelt, or written beside the inertial, it is reported there; an empty inertial elsewhere.
    if (inertial.child("inertia") || is_slip(model, inertial.id(), "inertia", findings)) return;
    if (const xml::View misplaced = inertial.parent().child("inertia")) {
      return findings.add_consequence(misplaced.name_span());
    }
    if (!inertial.child("mass")) return;
    findings.report(inertial.name_span(), "the inertial of " + title(link) + " has no inertia")
        .note("urdfdom drops the visuals and collisions of this link");
  });
}

constexpr Fact kFacts[] = {
    urdfdom_drops_shapes(),
    {&readers::pybullet, Effect::refuses, "refuses the whole robot", kRun},
    {&readers::mujoco, Effect::refuses, "refuses the file", kRun},
    {&readers::drake, Effect::takes, "reads no inertia", kRun},
};

}  // namespace

extern constinit const Rule sml1505_inertia_missing{
    .id = "SML1505",
    .name = "inertia-missing",
    .severity = Severity::error,
    .summary = "An inertial has a mass, but no inertia.",
    .remedy = "Add the inertia; it can be computed from the geometry and the mass.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1505_inertia_missing_file
