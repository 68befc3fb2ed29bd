// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml3112_joint6dof_on_root_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  for (const Sensor& sensor : model.annotations.sensors) {
    if (!sensor.type || *sensor.type != "Joint6DOF" || !sensor.link) continue;
    const auto index = model.link_names.find(*sensor.link);
    if (!index || model.tree.parent_joint[*index]) continue;
    Diagnostic& diagnostic = findings.report(
        sensor.link.span, "no joint leads to " + quoted(*sensor.link) + ", but " +
                              subject("sensor", sensor) + " should measure its forces");
    diagnostic.label(model.robot->links[*index].name.span, "the root link");
    diagnostic.note("MARS dereferences a null pointer");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes,
     "measures the joint that leads to the link, and dereferences a null pointer",
     "MARS smurf.cpp:277-283, run"},
    {&readers::phobos, Effect::changes, "keeps a sensor that measures no joint", kRun},
};

}  // namespace

extern constinit const Rule sml3112_joint6dof_on_root{
    .id = "SML3112",
    .name = "joint6dof-on-root",
    .severity = Severity::error,
    .summary = "A Joint6DOF sensor is on the root link.",
    .remedy = "Name a link that is the child of a joint.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3112_joint6dof_on_root_file
