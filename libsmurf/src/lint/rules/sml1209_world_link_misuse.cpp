// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "readers/circumstances.hpp"

namespace smurf::rules::sml1209_world_link_misuse_file {
namespace {

constexpr Circumstance kMoving{"moving"};

void check(const LinkedModel& model, Findings& findings) {
  const auto index = model.link_names.find("world");
  if (!index) return;
  const urdf::Link& link = model.robot->links[*index];
  if (const auto above = model.tree.parent_joint[*index]) {
    const urdf::Joint& joint = model.joint(*above);
    Diagnostic& diagnostic =
        findings.report(joint.child.span, title(joint) + " leads to the link `world`");
    diagnostic.label(link.name.span, "Gazebo, Drake and MuJoCo treat this as the world");
    if (joint.is_movable()) diagnostic.when(kMoving);
    return;
  }
  if (model.robot->links.size() == 1) {
    findings.report(link.name.span, "the link `world` is the only link").when(kAlone);
    return;
  }
  if (!link.inertial && link.collisions.empty()) return;
  const bool has_mass = link.inertial.has_value();
  findings
      .report(tag_name(model, has_mass ? link.inertial->element : link.collisions[0].element),
              std::string("the link `world` has ") + (has_mass ? "an inertial" : "a collision"))
      .label(link.name.span, "Gazebo, Drake and MuJoCo treat this as the world");
}

constexpr std::string_view kDrops =
    "treats it as the world itself, and drops its inertial and collisions";

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::refuses, "refuses a joint that moves the world", kRun,
     when(kMoving)},
    {&readers::gazebo, Effect::refuses, "treats it as the world: a model without links", kRun,
     when(kAlone)},
    {&readers::gazebo, Effect::loses, kDrops, "sdformat parser_urdf.cc:3397, run"},
    {&readers::mujoco, Effect::refuses, "refuses a joint that moves the world", kRun,
     when(kMoving)},
    {&readers::mujoco, Effect::loses, kDrops, kRun},
    {&readers::drake, Effect::loses, "treats it as the world itself, and drops its inertial", kRun},
};

}  // namespace

extern constinit const Rule sml1209_world_link_misuse{
    .id = "SML1209",
    .name = "world-link-misuse",
    .severity = Severity::warning,
    .summary = "A link named `world` has a mass or collisions, or is the child of a joint.",
    .why = "Other readers see an ordinary link.",
    .remedy = "Keep `world` as an empty root, or give the link another name.",
    .check_model = check,
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules::sml1209_world_link_misuse_file
