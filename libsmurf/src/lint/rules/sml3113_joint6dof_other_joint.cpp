// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/text/edits.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml3113_joint6dof_other_joint_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  for (const Sensor& sensor : model.annotations.sensors) {
    if (!sensor.type || *sensor.type != "Joint6DOF" || !sensor.link || !sensor.joint) continue;
    const auto link = model.link_names.find(*sensor.link);
    const urdf::Joint* joint = model.find_joint(*sensor.joint);
    if (!link || joint == nullptr || !model.tree.parent_joint[*link]) continue;
    const urdf::Joint& measured = model.joint(*model.tree.parent_joint[*link]);
    if (&measured == joint) continue;
    Diagnostic& diagnostic = findings.report(
        sensor.joint.span, "in MARS, " + subject("sensor", sensor) + " measures " +
                               title(measured) + ", which leads to " + quoted(*sensor.link) +
                               "; in MARS 2, it measures " + quoted(*sensor.joint));
    diagnostic.label(sensor.link.span, "MARS uses the link");
    if (!measured.name) continue;
    diagnostic.help("did you mean " + quoted(*measured.name) + "?");
    if (!fits_everywhere(*measured.name)) continue;
    diagnostic.fixes.push_back(
        {Applicability::unsafe, {{within_quotes(model, sensor.joint.span), *measured.name}}});
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "ignores `joint` and measures the joint that leads to `link`",
     "MARS smurf.cpp:277-283"},
    {&readers::mars2, Effect::takes, "measures the joint that `joint` names",
     "envire_smurf_loader Model.cpp:487-505"},
};

}  // namespace

extern constinit const Rule sml3113_joint6dof_other_joint{
    .id = "SML3113",
    .name = "joint6dof-other-joint",
    .severity = Severity::warning,
    .summary = "A Joint6DOF sensor names a joint that does not lead to its link.",
    .why = "The same sensor measures different joints in different readers.",
    .remedy = "Name the joint whose child the link is.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3113_joint6dof_other_joint_file
