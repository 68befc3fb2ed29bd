// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_link(model, [&](const urdf::Link& link) {
    if (!link.inertial) return;
    const xml::View inertial(model.robot->document, link.inertial->element);
    // Misspelt, or written beside the inertial, it is reported there.
    if (inertial.child("mass") || has_slip(model, inertial.id(), "mass")) return;
    if (inertial.parent().child("mass")) return;
    const bool has_inertia = inertial.child("inertia") || has_slip(model, inertial.id(), "inertia");
    findings
        .report(inertial.name_span(),
                "the inertial of " + title(link) + (has_inertia ? " has no mass" : " is empty"))
        .notes.push_back("urdfdom drops the visuals and collisions of this link");
  });
}

}  // namespace

extern constinit const Rule sml1504_mass_missing{
    .id = "SML1504",
    .name = "mass-missing",
    .severity = Severity::error,
    .summary = "An inertial has no mass.",
    .why = "urdfdom keeps the mass 0 and drops the visuals and collisions of the link, while the "
           "file \"loads\"; MuJoCo and Bullet refuse the file.",
    .remedy = "Add `<mass value=\"...\"/>` in kg.",
    .sources = "urdfdom 3.0.1 link.cpp:415-486, MuJoCo 3.14 and Bullet, executed.",
    .check_model = check};

}  // namespace smurf::rules
