// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View extension(model.robot->document, id);
    const xml::View joint = extension.name() == "gazebo" ? extension.child("joint") : xml::View();
    if (!joint && extension.name() != "loop_joint") continue;
    findings.report((joint ? joint : extension).name_span(),
                    joint ? "a joint that only sdformat (Gazebo) reads"
                          : "a `loop_joint`, which Isaac reads and Drake refuses");
  }
}

}  // namespace

extern constinit const Rule sml1211_closed_chain{
    .id = "SML1211",
    .name = "closed-chain",
    .severity = Severity::info,
    .summary = "A robot has a closed chain that only some readers know.",
    .why = "URDF describes trees. `loop_joint` is read by Isaac, a joint inside `gazebo` by "
           "sdformat; Drake refuses `loop_joint`, all others ignore both and load an open chain.",
    .remedy = "Write the loop for each target, e.g. in the annotations of the model, and check "
              "that it is closed there.",
    .sources = "Drake detail_urdf_parser.cc:1522; Isaac UrdfParser.cpp; sdformat "
               "parser_urdf.cc:1273.",
    .check_model = check};

}  // namespace smurf::rules
