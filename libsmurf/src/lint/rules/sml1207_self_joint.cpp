// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.parent || !joint.child || *joint.parent != *joint.child) return;
    if (!model.link_names.contains(*joint.child)) return;  // reported where it is unknown
    Diagnostic& diagnostic =
        findings.report(joint.child.span,
                        title(joint) + " connects the link " + quoted(*joint.child) + " to itself");
    diagnostic.labels.push_back({joint.parent.span, "the same link as parent"});
  });
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::changes,
     "accepts it; programs that walk the tree do not come to an end",
     "urdfdom issue 154; check_urdf 3.0.1, run"},
    {&readers::phobos, Effect::refuses, "stops with an exception", "Phobos a613e31, run"},
    {&readers::gazebo, Effect::crashes, "crashes", kRun},
    {&readers::dart, Effect::crashes, "does not come to an end", kRun},
};

}  // namespace

extern constinit const Rule sml1207_self_joint{.id = "SML1207",
                                               .name = "self-joint",
                                               .severity = Severity::error,
                                               .summary = "A joint connects a link to itself.",
                                               .remedy = "Name two different links.",
                                               .check_model = check,
                                               .facts = kFacts,
                                               .is_impossible = true,
                                               .blocks_building = true};

}  // namespace smurf::rules
