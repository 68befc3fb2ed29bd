// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "base/text/quoted.hpp"
#include "lint/companions/srdf_queries.hpp"

namespace smurf::rules::sml3512_srdf_state_outside_group_file {
namespace {

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  for_each_state(
      model, companions,
      [&](const srdf::Description& srdf, const srdf::GroupState& state, const GroupJoints& joints) {
        if (!joints.is_complete) return;
        Diagnostic* first = nullptr;
        std::string others;
        for (const srdf::StateJoint& one : state.joints) {
          if (!one.name || joints.contains(model, *one.name)) continue;
          const urdf::Joint* joint = model.find_joint(*one.name);
          if (joint == nullptr && srdf.find_virtual_joint(*one.name) == nullptr) continue;
          if (first != nullptr) {
            others += (others.empty() ? "" : ", ") + quoted(*one.name);
            continue;
          }
          first = &findings.report(one.name.span, title_of("state", state.name) +
                                                      " sets the joint " + quoted(*one.name) +
                                                      ", which is not in the group " +
                                                      quoted(*state.group));
          first->help("add the joint to the group, or delete it from the state");
        }
        if (!others.empty()) first->note("this also applies to " + shortened(others, 200));
      });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::breaks, "reports an error and ignores the joint in the state",
     "moveit2 robot_model.cpp addJointModelGroup"},
};

}  // namespace

extern constinit const Rule sml3512_srdf_state_outside_group{
    .id = "SML3512",
    .name = "srdf-state-outside-group",
    .severity = Severity::error,
    .summary = "A group state sets a joint that is not in its group.",
    .remedy = "Add the joint to the group, or delete it from the state.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3512_srdf_state_outside_group_file
