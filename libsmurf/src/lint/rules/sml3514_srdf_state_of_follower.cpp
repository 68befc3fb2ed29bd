// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <string>

#include "base/text/quoted.hpp"
#include "lint/companions/srdf_queries.hpp"

namespace smurf::rules::sml3514_srdf_state_of_follower_file {
namespace {

constexpr Circumstance kFixed{"fixed"};
constexpr Circumstance kMimic{"mimic"};

/// One finding for all followers in the states of an SRDF, and one for all fixed joints.
class States {
 public:
  explicit States(Findings& findings) : findings_(findings) {}

  void check(const srdf::GroupState& state, const srdf::StateJoint& one, const urdf::Joint& joint) {
    state_ = &state;
    const std::string subject =
        title_of("state", state.name) + " sets the joint " + quoted(*one.name);
    if (joint.type == urdf::JointType::fixed) {
      add(fixed_, one, joint, subject + ", which is fixed", kFixed);
    } else if (joint.mimic && joint.mimic->joint) {
      add(mimic_, one, joint, subject + ", which follows " + quoted(*joint.mimic->joint), kMimic);
    }
  }

  void finish() {
    for (const Kind* kind : {&fixed_, &mimic_}) {
      if (!kind->others.empty()) {
        kind->first->note("this also applies to " + shortened(kind->others, 200));
      }
    }
  }

 private:
  struct Kind {
    Diagnostic* first = nullptr;
    const srdf::GroupState* first_in = nullptr;
    std::string others;
  };

  void add(Kind& kind, const srdf::StateJoint& one, const urdf::Joint& joint,
           const std::string& message, const Circumstance& which) {
    if (kind.first != nullptr) {
      kind.others += (kind.others.empty() ? "" : ", ") + quoted(*one.name);
      if (kind.first_in != state_) kind.others += " in " + title_of("state", state_->name);
      return;
    }
    kind.first_in = state_;
    kind.first = &findings_.report(one.name.span, message);
    kind.first->when(which);
    kind.first->label(joint.name.span, "the joint is defined here")
        .help("delete it from the state");
  }

  const srdf::GroupState* state_ = nullptr;
  Findings& findings_;
  Kind fixed_, mimic_;
};

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  std::map<const srdf::Description*, States> checkers;
  for_each_state(
      model, companions,
      [&](const srdf::Description& srdf, const srdf::GroupState& state, const GroupJoints& joints) {
        States& checker = checkers.try_emplace(&srdf, findings).first->second;
        for (const srdf::StateJoint& one : state.joints) {
          const urdf::Joint* joint = one.name ? model.find_joint(*one.name) : nullptr;
          if (joint == nullptr) continue;
          // SML3512 reports joints of other groups.
          const bool is_inside = !joints.is_complete || joints.contains(model, *one.name);
          if (is_inside) checker.check(state, one, *joint);
        }
      });
  for (auto& [srdf, checker] : checkers) checker.finish();
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
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3514_srdf_state_of_follower_file
