// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/lists.hpp"
#include "base/text/quoted.hpp"
#include "lint/companions/controllers.hpp"
#include "lint/companions/moveit_files.hpp"
#include "lint/companions/srdf_queries.hpp"

namespace smurf::rules::sml3814_moveit_uncovered_joint_file {
namespace {

/// The controllers in the files of MoveIt.
struct Lists {
  struct One {
    yaml::View joints;
    std::set<std::string_view> names;
  };
  std::vector<One> all;
  std::set<std::string_view> covered;
  bool is_known = true;

  void add(yaml::View joints) {
    One one{joints, {}};
    for (const yaml::View item : joints) {
      if (!item.is_scalar() || is_placeholder(item.text())) {
        is_known = false;
        continue;
      }
      one.names.insert(item.text());
      covered.insert(item.text());
    }
    all.push_back(std::move(one));
  }
  // The recursion is as deep as the file, whose depth is limited.
  void read(yaml::View mapping) {
    for (const yaml::View member : mapping) {
      if (member.key() == "joints" && member.is_sequence()) add(member);
      if (member.is_mapping() || member.key() == "controller_list") read(member);
    }
  }
};

/// The names of the joints of a group that move by themselves.
std::set<std::string_view> driven_joints(const LinkedModel& model, const srdf::Description& srdf,
                                         const GroupJoints& joints) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < joints.of_robot.size(); ++i) {
    const urdf::Joint& one = model.robot->joints[i];
    const bool is_driven = joints.of_robot[i] && one.is_movable() && !one.mimic && one.name;
    const bool is_passive =
        is_driven && std::any_of(srdf.passive_joints.begin(), srdf.passive_joints.end(),
                                 [&](const srdf::PassiveJoint& passive) {
                                   return passive.name && *passive.name == *one.name;
                                 });
    if (is_driven && !is_passive) names.insert(*one.name);
  }
  return names;
}

void check_group(const std::set<std::string_view>& joints, const std::string& group,
                 const Lists& lists, std::set<std::string_view>& told, Findings& findings) {
  std::vector<std::string_view> missing;
  std::set_difference(joints.begin(), joints.end(), lists.covered.begin(), lists.covered.end(),
                      std::back_inserter(missing));
  // A group of an arm and of a hand that nothing drives is meant so.
  if (missing.size() * 2 > joints.size()) return;
  std::erase_if(missing, [&](std::string_view one) { return told.contains(one); });
  if (missing.empty()) return;
  const Lists::One* best = nullptr;
  for (const Lists::One& one : lists.all) {
    const bool is_inside =
        std::includes(joints.begin(), joints.end(), one.names.begin(), one.names.end());
    if (!one.names.empty() && is_inside &&
        (best == nullptr || one.names.size() > best->names.size()))
      best = &one;
  }
  if (best == nullptr) return;
  const std::string names = listed(all_quoted(missing));
  told.insert(missing.begin(), missing.end());
  findings
      .report(best->joints.key_span(),
              "no controller of MoveIt has " + shortened(names, 200) + " of the group " + group)
      .help("add " + std::string(missing.size() == 1 ? "it" : "them") +
            " to the controller, or to another one in `controller_names`");
}

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  const Companion* only = only_srdf(companions);
  if (only == nullptr || !model.robot) return;
  Lists lists;
  for_each_file(companions, CompanionKind::moveit_controllers,
                [&](const Companion&, yaml::View root) { lists.read(root); });
  for (const std::string_view one : lists.covered) {
    if (!model.joint_index(one)) lists.is_known = false;  // SML3802 reports the name
  }
  if (!lists.is_known || lists.all.empty()) return;
  struct Group {
    std::string title;
    std::set<std::string_view> joints;
  };
  std::vector<Group> groups;
  for (const srdf::Group& group : only->srdf->groups) {
    const GroupJoints joints = joints_of(model, *only->srdf, group);
    if (joints.is_complete && group.name)
      groups.push_back({quoted(*group.name), driven_joints(model, *only->srdf, joints)});
  }
  // The smallest group that lacks a joint is the one that is meant.
  std::stable_sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) {
    return a.joints.size() < b.joints.size();
  });
  std::set<std::string_view> told;
  for (const Group& group : groups) {
    const bool is_untouched =
        std::none_of(group.joints.begin(), group.joints.end(),
                     [&](std::string_view one) { return lists.covered.contains(one); });
    if (is_untouched) {
      told.insert(group.joints.begin(), group.joints.end());  // nothing drives it
    } else {
      check_group(group.joints, group.title, lists, told, findings);
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::breaks,
     "plans for the group, but executes nothing: no controllers have all of its joints",
     "moveit2 trajectory_execution_manager.cpp selectControllers"},
};

}  // namespace

extern constinit const Rule sml3814_moveit_uncovered_joint{
    .id = "SML3814",
    .name = "moveit-uncovered-joint",
    .severity = Severity::warning,
    .summary = "No controller of MoveIt has a joint of a group that the controllers drive.",
    .remedy = "Add the joint to a controller, or declare it passive in the SRDF.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3814_moveit_uncovered_joint_file
