// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1504_mass_missing_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_link(model, [&](const urdf::Link& link) {
    if (!link.inertial) return;
    const xml::View inertial(model.robot->document, link.inertial->element);
    // Misspelt, or written beside the inertial, it is reported there.
    if (inertial.child("mass") || is_slip(model, inertial.id(), "mass", findings)) return;
    if (const xml::View misplaced = inertial.parent().child("mass")) {
      return findings.add_consequence(misplaced.name_span());
    }
    const bool has_inertia = inertial.child("inertia") || has_slip(model, inertial.id(), "inertia");
    findings
        .report(inertial.name_span(),
                "the inertial of " + title(link) + (has_inertia ? " has no mass" : " is empty"))
        .note("urdfdom drops the visuals and collisions of this link");
  });
}

constexpr Fact kFacts[] = {
    urdfdom_drops_shapes(),
    {&readers::pybullet, Effect::refuses, "refuses the whole robot", kRun},
    {&readers::mujoco, Effect::refuses, "refuses the file", kRun},
    {&readers::drake, Effect::changes,
     "reads no mass, and replaces a body of such an inertia by a sphere of 1 kg", kRun},
};

}  // namespace

extern constinit const Rule sml1504_mass_missing{.id = "SML1504",
                                                 .name = "mass-missing",
                                                 .severity = Severity::error,
                                                 .summary = "An inertial has no mass.",
                                                 .remedy = "Add `<mass value=\"...\"/>` in kg.",
                                                 .check_model = check,
                                                 .facts = kFacts};

}  // namespace smurf::rules::sml1504_mass_missing_file
