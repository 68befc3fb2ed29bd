// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "lint/companions/srdf_queries.hpp"

namespace smurf::rules::sml3515_srdf_state_incomplete_file {
namespace {

bool sets(const srdf::GroupState& state, std::string_view joint) {
  return std::any_of(state.joints.begin(), state.joints.end(),
                     [&](const srdf::StateJoint& one) { return one.name && *one.name == joint; });
}

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  for_each_state(
      model, companions,
      [&](const srdf::Description& srdf, const srdf::GroupState& state, const GroupJoints& joints) {
        // A joint that is meant may have another name here: SML3501 and SML3512 report it.
        const bool has_other =
            std::any_of(state.joints.begin(), state.joints.end(), [&](const srdf::StateJoint& one) {
              return one.name && !joints.contains(model, *one.name) && joints.is_complete;
            });
        if (has_other) return;
        std::string missing;
        for (std::size_t i = 0; i < joints.of_robot.size(); ++i) {
          const urdf::Joint& joint = model.robot->joints[i];
          const bool is_set_alone = joint.is_movable() && !joint.mimic && joint.name;
          if (!joints.of_robot[i] || !is_set_alone || sets(state, *joint.name)) continue;
          missing += (missing.empty() ? "" : ", ") + quoted(*joint.name);
        }
        if (missing.empty()) return;
        findings
            .report(place_of(srdf, state.name, state.element),
                    title_of("state", state.name) + " does not set " + shortened(missing, 200) +
                        " of the group " + quoted(*state.group))
            .help("write a position for each joint of the group");
      });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::ignores, "warns; the joints keep their positions",
     "moveit2 robot_model.cpp addJointModelGroup"},
};

}  // namespace

extern constinit const Rule sml3515_srdf_state_incomplete{
    .id = "SML3515",
    .name = "srdf-state-incomplete",
    .severity = Severity::info,
    .summary = "A group state does not set all joints of its group.",
    .remedy = "Write a position for each joint of the group.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3515_srdf_state_incomplete_file
