// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "readers/circumstances.hpp"

namespace smurf::rules::sml1205_no_root_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot || model.robot->links.empty() || !model.tree.roots.empty()) return;
  // The joint to blame is the one whose child was first used as a parent.
  const std::vector<urdf::Joint>& joints = model.robot->joints;
  for (std::size_t i = joints.size(); i-- > 0;) {
    const auto child = model.tree.joint_child[i];
    if (!child || to_size(*child) != 0) continue;
    Diagnostic& diagnostic = findings.report(
        joints[i].child.span, title(joints[i]) + " closes a loop: every link has a parent");
    diagnostic.label(name_place(model, model.link(*child)), "the first link");
    return;
  }
  findings.report(tag_name(model, model.robot->document.root),
                  "every link is the child of a joint, so there is no root link");
}

constexpr Fact kFacts[] = {
    {&readers::drake, Effect::loses, "leaves out a floating joint", kRun, when(kInFloating)},
    {&readers::urdf, Effect::refuses, "refuses the file: it finds no root",
     "urdfdom model.h:176, run"},
};

}  // namespace

extern constinit const Rule sml1205_no_root{.id = "SML1205",
                                            .name = "no-root",
                                            .severity = Severity::error,
                                            .summary =
                                                "Every link of a robot is the child of a joint.",
                                            .why = "The robot has no root link.",
                                            .remedy = "Remove the joint that closes the loop.",
                                            .check_model = check,
                                            .facts = kFacts,
                                            .blocks_building = true};

}  // namespace smurf::rules::sml1205_no_root_file
