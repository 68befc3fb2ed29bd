// SPDX-License-Identifier: BSD-3-Clause
#include "lint/companions/srdf_queries.hpp"

namespace smurf::rules::sml3500_srdf_without_robot_file {
namespace {

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  if (model.robot) return;
  for_each_srdf(companions, [&](const srdf::Description& srdf) {
    const xml::View root = srdf.document.view();
    if (!root) return;
    const std::string robot = srdf.name ? "robot " + quoted(*srdf.name) : "robot of that name";
    findings
        .report(place_of(srdf, srdf.name, root.id()),
                "no URDF of the " + robot +
                    " was found, so names of links and joints are not "
                    "checked")
        .help("check the package of the robot, a URDF or a xacro, together with this one");
  });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::takes, "gets the URDF from `robot_description`",
     "moveit2 rdf_loader.cpp"},
};

}  // namespace

extern constinit const Rule sml3500_srdf_without_robot{
    .id = "SML3500",
    .name = "srdf-without-robot",
    .severity = Severity::info,
    .summary = "No URDF with the robot name of an SRDF was found.",
    .why = "Names of links and joints in the SRDF were not compared with a robot.",
    .remedy = "Check the package of the URDF together with the SRDF.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3500_srdf_without_robot_file
