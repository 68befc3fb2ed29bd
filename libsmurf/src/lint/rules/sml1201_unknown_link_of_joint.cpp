// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/findings/readers.hpp"
#include "base/text/counted.hpp"
#include "lint/mimic_queries.hpp"
#include "lint/model_answers.hpp"
#include "lint/name_queries.hpp"
#include "lint/reference_queries.hpp"

namespace smurf::rules::sml1201_unknown_link_of_joint_file {
namespace {

constexpr Circumstance kDrakeWorld{"world of Drake", &readers::drake};
constexpr Circumstance kWorld{"world"};
constexpr Circumstance kDriven{"driven"};

using Names = std::set<std::string_view>;

Names joints_with_motor(const LinkedModel& model) {
  Names driven;
  for (const Motor& motor : model.annotations.motors) {
    if (motor.joint) driven.insert(*motor.joint);
  }
  return driven;
}

bool has_name_in(xml::View joint, const Names& names) {
  const xml::Attribute* name = joint.attribute("name");
  return name != nullptr && names.contains(name->value());
}

/// The links to which no joint leads. If there is only one, it is the root, as it should be.
UnusedNames links_without_joint(const LinkedModel& model) {
  Names children;
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (joint.child) children.insert(*joint.child);
  });
  UnusedNames unused{{}, {}, "to which no joint leads"};
  for_each_link(model, [&](const urdf::Link& link) {
    if (link.name && !children.contains(*link.name)) unused.names.push_back(*link.name);
  });
  if (unused.names.size() == 1) unused.names.clear();
  return unused;
}

/// The only link that no joint names, if the robot has others; otherwise "".
std::string_view lone_link(const LinkedModel& model) {
  Names named;
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (joint.parent) named.insert(*joint.parent);
    if (joint.child) named.insert(*joint.child);
  });
  std::string_view lone;
  std::size_t count = 0;
  for_each_link(model, [&](const urdf::Link& link) {
    if (!link.name || named.contains(*link.name)) return;
    lone = *link.name;
    ++count;
  });
  return count == 1 && model.robot->links.size() > 1 ? lone : std::string_view();
}

/// Whether one is the other with something added: `base` and `base_link`.
bool is_extended(std::string_view one, std::string_view other) {
  if (one.empty() || other.empty()) return false;
  return one.find(other) != one.npos || other.find(one) != other.npos;
}

/// Joints that name the same absent link, of which the first is reported.
struct Followers {
  Diagnostic* first = nullptr;
  std::vector<std::string> joints;

  /// Writes the name that was meant there, too.
  void add(const std::string& joint, Span place) {
    joints.push_back(joint);
    if (first->fixes.empty() || first->fixes.front().edits.size() < joints.size()) return;
    std::vector<Edit>& edits = first->fixes.front().edits;
    edits.push_back({place, edits.front().text});
  }
  void tell() const {
    constexpr std::size_t kNamed = 3;
    if (joints.empty()) return;
    std::string text =
        joints.size() == 1 ? "" : counted(joints.size(), "more joint") + " name it: ";
    for (std::size_t i = 0; i < std::min(joints.size(), kNamed); ++i) {
      text += (i == 0 ? "" : ", ") + joints[i];
    }
    if (joints.size() > kNamed) text += " ...";
    first->note(joints.size() == 1 ? text + " names it, too" : text);
  }
};

/// Whether `above` is the other link, or joints lead from it to the other link.
bool is_above(const LinkedModel& model, std::string_view above, std::string_view name) {
  const std::optional<LinkIndex> wanted = model.link_index(above);
  std::optional<LinkIndex> at = model.link_index(name);
  for (std::size_t i = 0; wanted && at && i <= model.tree.parent_joint.size(); ++i) {
    if (*at == *wanted) return true;
    const std::optional<JointIndex> joint = model.tree.parent_joint[to_size(*at)];
    at = joint ? model.tree.joint_parent[to_size(*joint)] : std::nullopt;
  }
  return false;
}

/// A joint does not lead from a link to itself, or back to a link above.
Meanings meanings_of(const LinkedModel& model, xml::View end, std::string_view name,
                     std::string_view lone) {
  const std::string_view other = other_link(end);
  Meanings meanings;
  meanings.own = other;
  meanings.is_impossible = [&model, other,
                            is_child = end.name() == "child"](std::string_view meant) {
    return is_child ? is_above(model, meant, other) : is_above(model, other, meant);
  };
  if (is_extended(lone, name) && !meanings.is_impossible(lone)) {
    meanings.unused = [lone] { return UnusedNames{{lone}, lone, "which no joint names"}; };
  } else if (end.name() == "child") {
    meanings.unused = [&model] { return links_without_joint(model); };
  }
  return meanings;
}

void check(const LinkedModel& model, Findings& findings) {
  if (findings.answers().doubtful_references().empty()) return;
  const urdf::Link* unnamed = link_without_name(model);
  const Names driven = joints_with_motor(model), followed = followed_joints(model);
  const std::string_view lone = model.robot ? lone_link(model) : std::string_view();
  std::map<std::string_view, Followers> parents;  // by the name of an absent parent
  for (const Reference& one : findings.answers().doubtful_references()) {
    const xml::View end = element_of(model, one);
    if (!end || (end.name() != "parent" && end.name() != "child")) continue;
    const std::string subject = subject_of(end.parent());
    const auto known = end.name() == "parent" ? parents.find(one.name) : parents.end();
    if (known != parents.end()) {
      known->second.add(subject, one.span);
      if (has_name_in(end.parent(), driven)) known->second.first->when(kDriven);
      continue;
    }
    Diagnostic* diagnostic = check_link_of_joint(model, one, subject, unnamed, findings,
                                                 meanings_of(model, end, one.name, lone));
    if (diagnostic != nullptr && end.name() == "parent") parents[one.name].first = diagnostic;
    if (diagnostic != nullptr && has_name_in(end.parent(), driven)) diagnostic->when(kDriven);
    if (diagnostic != nullptr && one.name == "world") {
      diagnostic->when(kWorld);
      if (has_name_in(end.parent(), followed)) diagnostic->when(kFollowed);
    }
    if (diagnostic != nullptr && end.name() == "parent" && one.name == "world") {
      diagnostic->when(kDrakeWorld);
      diagnostic->note(
          "only Drake has a link `world` without a declaration; check files for Drake with "
          "`--target drake`");
      diagnostic->help("declare it: `<link name=\"world\"/>`");
    }
  }
  for (const auto& [name, followers] : parents) followers.tell();
}

constexpr Fact kFacts[] = {
    {&readers::phobos, Effect::refuses, "stops with an UnboundLocalError at the motor of the joint",
     "Phobos io/smurfrobot.py:211-215, run", at("parent/@link").when(kDriven)},
    {&readers::phobos, Effect::breaks, "keeps a joint without a parent", kRun, at("parent")},
    {&readers::urdf, Effect::refuses, "refuses the file",
     "urdfdom model.h:128; MuJoCo, Bullet, run"},
    {&readers::drake, Effect::takes, "has a link `world` that no file declares", kRun,
     when(kDrakeWorld)},
    drake_misses_leader(at("child").when(kWorld, kFollowed)),
    {&readers::drake, Effect::changes, "takes its own world for the child", kRun,
     at("child").when(kWorld)},
};

}  // namespace

extern constinit const Rule sml1201_unknown_link_of_joint{
    .id = "SML1201",
    .name = "unknown-link-of-joint",
    .severity = Severity::error,
    .summary = "The parent or child of a joint is a link that the robot does not have.",
    .why = "urdf-loader draws half a robot.",
    .remedy = "Correct the name, or declare the link.",
    .check_model = check,
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules::sml1201_unknown_link_of_joint_file
