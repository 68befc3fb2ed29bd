// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1917_root_with_inertial_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot || model.tree.roots.size() != 1) return;
  const LinkIndex root = model.tree.roots.front();
  const urdf::Link& link = model.link(root);
  if (!link.inertial || model.tree.child_joints[to_size(root)].empty()) return;
  findings.report(tag_name(model, link.inertial->element),
                  "the root " + title(link) + " has an inertial");
}

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::loses, "KDL warns, and computes without the mass of the root",
     "kdl_parser"},
    {&readers::mujoco, Effect::ignores, "welds the root to the world, where its mass has no effect",
     "MuJoCo xml_urdf.cc:366, run"},
};

}  // namespace

extern constinit const Rule sml1917_root_with_inertial{
    .id = "SML1917",
    .name = "root-with-inertial",
    .severity = Severity::warning,
    .summary = "The root link has an inertial, which a target leaves out.",
    .remedy = "Add a new root link without an inertial, and connect the two by a fixed joint.",
    .sources = "84 of 322 files of the Tola/Corke dataset.",
    .check_model = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml1917_root_with_inertial_file
