// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1211_closed_chain_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View extension(model.robot->document, id);
    const xml::View joint = extension.name() == "gazebo" ? extension.child("joint") : xml::View();
    if (!joint && extension.name() != "loop_joint") continue;
    findings.report((joint ? joint : extension).name_span(),
                    joint ? "a joint that only sdformat (Gazebo) reads"
                          : "a `loop_joint`, which Drake refuses and the others ignore");
  }
}

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::ignores, "ignores it and loads an open chain",
     "urdfdom, MuJoCo and Bullet, run"},
    {&readers::gazebo, Effect::takes, "reads a joint inside `gazebo`",
     "sdformat parser_urdf.cc:1273", at("gazebo")},
    {&readers::drake, Effect::refuses, "refuses `loop_joint`", kRun, at("loop_joint")},
};

}  // namespace

extern constinit const Rule sml1211_closed_chain{
    .id = "SML1211",
    .name = "closed-chain",
    .severity = Severity::info,
    .summary = "A robot has a closed chain that only some readers support.",
    .why = "URDF describes trees.",
    .remedy =
        "Write the loop for each target, e.g. in the annotations of the model, and check that it "
        "is closed there.",
    .sources = "The older importer of Isaac Sim read `loop_joint` (UrdfParser.cpp).",
    .check_model = check,
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules::sml1211_closed_chain_file
