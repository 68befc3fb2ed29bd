// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1425_dynamics_empty_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.dynamics || joint.dynamics->damping.written || joint.dynamics->friction.written) {
      return;
    }
    // Other rules report values that are written as elements or misspelt.
    const xml::View element(model.robot->document, joint.dynamics->element);
    if (element.child("damping") || element.child("friction")) return;
    if (is_slip(model, element.id(), "damping", findings) ||
        is_slip(model, element.id(), "friction", findings)) {
      return;
    }
    Diagnostic& diagnostic = findings.report(tag_name(model, joint.dynamics->element),
                                             "the `dynamics` element of " + title(joint) +
                                                 " has neither `damping` nor `friction`");
    diagnostic.note("urdfdom refuses the whole file");
    diagnostic.help("delete it");
    if (element.begin() == element.end() && element.element().attribute_count == 0) {
      diagnostic.fixes.push_back({Applicability::safe, {{joint.dynamics->span, ""}}});
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::drake, Effect::changes, "reads 0", kRun},
    {&readers::urdfdom, Effect::refuses, "refuses the file", kRun},
    {&readers::pybullet, Effect::refuses, "refuses the whole robot", "Bullet UrdfParser.cpp, run"},
    {&readers::mujoco, Effect::takes, "reads no damping and no friction", kRun},
};

}  // namespace

extern constinit const Rule sml1425_dynamics_empty{
    .id = "SML1425",
    .name = "dynamics-empty",
    .severity = Severity::error,
    .summary = "A dynamics element has neither damping nor friction.",
    .remedy = "Delete it, or write damping and friction.",
    .check_model = check,
    .facts = kFacts,
    .about = About::format};

}  // namespace smurf::rules::sml1425_dynamics_empty_file
