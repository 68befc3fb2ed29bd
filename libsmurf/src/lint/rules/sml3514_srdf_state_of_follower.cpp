// SPDX-License-Identifier: BSD-3-Clause
#include "lint/companions/srdf_queries.hpp"

namespace smurf::rules::sml3514_srdf_state_of_follower_file {
namespace {

constexpr Circumstance kFixed{"fixed"};
constexpr Circumstance kMimic{"mimic"};

void check_joint(const srdf::GroupState& state, const srdf::StateJoint& one,
                 const urdf::Joint& joint, Findings& findings) {
  const std::string subject =
      title_of("state", state.name) + " sets the joint " + quoted(*one.name);
  if (joint.type == urdf::JointType::fixed) {
    Diagnostic& found = findings.report(one.name.span, subject + ", which is fixed");
    found.when(kFixed);
    found.label(joint.name.span, "the joint is defined here").help("delete it from the state");
  } else if (joint.mimic && joint.mimic->joint) {
    Diagnostic& found =
        findings.report(one.name.span, subject + ", which follows " + quoted(*joint.mimic->joint));
    found.when(kMimic);
    found.label(joint.name.span, "the joint is defined here").help("delete it from the state");
  }
}

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  for_each_srdf(companions, [&](const srdf::Description& srdf) {
    for (const srdf::GroupState& state : srdf.states) {
      for (const srdf::StateJoint& one : state.joints) {
        const urdf::Joint* joint = one.name ? model.find_joint(*one.name) : nullptr;
        if (joint != nullptr) check_joint(state, one, *joint, findings);
      }
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::breaks, "reports an error and ignores the joint in the state",
     "moveit2 robot_model.cpp addJointModelGroup", when(kFixed)},
    {&readers::moveit, Effect::changes, "uses the position of the joint that it follows",
     "moveit2 robot_state.cpp updateMimicJoint", when(kMimic)},
};

}  // namespace

extern constinit const Rule sml3514_srdf_state_of_follower{
    .id = "SML3514",
    .name = "srdf-state-of-follower",
    .severity = Severity::warning,
    .summary = "A group state sets a fixed joint, or one that mimics another.",
    .remedy = "Delete the joint from the state.",
    .facts = kFacts};

}  // namespace smurf::rules::sml3514_srdf_state_of_follower_file

namespace smurf::companion_checks {

extern constinit const CompanionCheck sml3514_srdf_state_of_follower =
    rules::sml3514_srdf_state_of_follower_file::check;

}  // namespace smurf::companion_checks
