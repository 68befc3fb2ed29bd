// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  const auto index = model.link_names.find("world");
  if (!index) return;
  const urdf::Link& link = model.robot->links[*index];
  if (const auto above = model.tree.parent_joint[*index]) {
    const urdf::Joint& joint = model.joint(*above);
    findings.report(joint.child.span, title(joint) + " leads to the link `world`")
        .labels.push_back({link.name.span, "Gazebo, Drake and MuJoCo take this for the world"});
    return;
  }
  if (!link.inertial && link.collisions.empty()) return;
  const bool has_mass = link.inertial.has_value();
  findings
      .report(tag_name(model, has_mass ? link.inertial->element : link.collisions[0].element),
              std::string("the link `world` has ") + (has_mass ? "an inertial" : "a collision"))
      .labels.push_back({link.name.span, "Gazebo, Drake and MuJoCo take this for the world"});
}

}  // namespace

extern constinit const Rule sml1209_world_link_misuse{
    .id = "SML1209",
    .name = "world-link-misuse",
    .severity = Severity::warning,
    .summary = "A link named `world` has a mass or collisions, or hangs on a joint.",
    .why = "Gazebo, Drake and MuJoCo take a link of this name for the world itself: they drop its "
           "inertial and collisions, or refuse a joint that leads to it. Other readers see an "
           "ordinary link.",
    .remedy = "Leave `world` an empty root, or give the link another name.",
    .sources = "sdformat 12.3 (parser_urdf.cc:3397), MuJoCo 3.14 and DART 6.12, executed; Drake "
               "detail_urdf_parser.cc:203-216.",
    .check_model = check};

}  // namespace smurf::rules
