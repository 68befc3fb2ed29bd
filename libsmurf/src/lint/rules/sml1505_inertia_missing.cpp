// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_link(model, [&](const urdf::Link& link) {
    if (!link.inertial) return;
    const xml::View inertial(model.robot->document, link.inertial->element);
    // Misspelt, or written beside the inertial, it is reported there; an empty inertial elsewhere.
    if (inertial.child("inertia") || has_slip(model, inertial.id(), "inertia")) return;
    if (inertial.parent().child("inertia") || !inertial.child("mass")) return;
    findings.report(inertial.name_span(), "the inertial of " + title(link) + " has no inertia")
        .notes.push_back("urdfdom drops the visuals and collisions of this link");
  });
}

}  // namespace

extern constinit const Rule sml1505_inertia_missing{
    .id = "SML1505",
    .name = "inertia-missing",
    .severity = Severity::error,
    .summary = "An inertial has a mass, but no inertia.",
    .why = "urdfdom drops the visuals and collisions of the link, while the file \"loads\"; MuJoCo "
           "and Bullet refuse the file.",
    .remedy = "Add the inertia; it can be computed from the geometry and the mass.",
    .sources = "urdfdom 3.0.1 link.cpp:415-486, MuJoCo 3.14 and Bullet, executed.",
    .check_model = check};

}  // namespace smurf::rules
