// SPDX-License-Identifier: BSD-3-Clause
#include "lint/companions/srdf_queries.hpp"

namespace smurf::rules::sml3502_srdf_robot_name_file {
namespace {

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  if (!model.robot || !model.robot->name) return;
  const Field<std::string>& own = model.robot->name;
  for_each_srdf(companions, [&](const srdf::Description& srdf) {
    if (!srdf.name || *srdf.name == *own) return;
    Diagnostic& found = findings.report(
        srdf.name.span, "the SRDF is for the robot " + quoted(*srdf.name) +
                            ", but the URDF with its joints and links calls it " + quoted(*own));
    found.label(own.span, "the robot is named here");
    found.help("write the name of the URDF");
    found.fixes.push_back({Applicability::unsafe, {{srdf.name.span, *own}}});
  });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::changes, "reports an error and uses the SRDF nevertheless",
     "srdfdom model.cpp initXml"},
};

}  // namespace

extern constinit const Rule sml3502_srdf_robot_name{
    .id = "SML3502",
    .name = "srdf-robot-name",
    .severity = Severity::warning,
    .summary = "An SRDF has another robot name than the URDF that it belongs to.",
    .remedy = "Write the name of the URDF.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3502_srdf_robot_name_file
