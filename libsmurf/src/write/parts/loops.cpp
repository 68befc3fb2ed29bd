// SPDX-License-Identifier: BSD-3-Clause
#include "write/parts/loops.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/numbers/exact_math.hpp"
#include "base/numbers/numbers.hpp"
#include "base/numbers/vectors.hpp"
#include "convert/import.hpp"

namespace smurf {
namespace {

constexpr double kRounding = 1e-9;

Vector3 unit(const Vector3& v) {
  const double length = std::sqrt(dot(v, v));
  return length > 0 ? Vector3{v[0] / length, v[1] / length, v[2] / length} : Vector3{1, 0, 0};
}

double angle_between(const Vector3& a, const Vector3& b) {
  const Vector3 normal = cross(a, b);
  return arc_tangent(std::sqrt(dot(normal, normal)), dot(a, b));
}

std::optional<Loop> loop_of(const LinkedModel& model, std::size_t index) {
  const urdf::Joint& joint = model.robot->joints[index];
  Loop loop{.joint = &joint, .name = joint.name.value_or("loop"), .span = joint.span};
  if (joint.type == urdf::JointType::revolute || joint.type == urdf::JointType::continuous) {
    const std::optional<Vector3> axis = joint_axis(joint);
    if (!axis) return std::nullopt;
    loop.kind = LoopKind::hinge;
    loop.axis = unit(*axis);
  } else if (joint.type != urdf::JointType::fixed) {
    return std::nullopt;
  }
  loop.parent = to_size(*model.tree.joint_parent[index]);
  loop.child = to_size(*model.tree.joint_child[index]);
  loop.X_PJ = urdf::to_pose(joint.origin);
  return loop;
}

/// Numbers of a text; none unless there are `count`.
std::optional<std::vector<double>> numbers_in(std::string_view text, std::size_t count) {
  std::vector<double> numbers;
  while (!text.empty()) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) break;
    const std::size_t end = std::min(text.find_first_of(" \t\r\n", begin), text.size());
    const auto number = parse_number(text.substr(begin, end - begin));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    text.remove_prefix(end);
  }
  return numbers.size() == count ? std::optional(numbers) : std::nullopt;
}

/// A joint in `<gazebo>` is one of SDF: its pose is that in the child.
std::optional<Loop> loop_of(const LinkedModel& model, xml::View joint) {
  if (joint.name() != "joint") return std::nullopt;
  const auto parent = model.link_names.find(import::child_text(joint, "parent"));
  const auto child = model.link_names.find(import::child_text(joint, "child"));
  const std::string_view type = attribute_of(joint, "type");
  if (!parent || !child || *parent == *child) return std::nullopt;
  Loop loop{.name = std::string(attribute_of(joint, "name")),
            .parent = *parent,
            .child = *child,
            .span = joint.name_span()};
  if (type == "revolute") {
    const xml::View axis = joint.child("axis");
    const auto xyz = numbers_in(axis ? import::child_text(axis, "xyz") : "", 3);
    if (!xyz) return std::nullopt;
    loop.kind = LoopKind::hinge;
    loop.axis = unit({(*xyz)[0], (*xyz)[1], (*xyz)[2]});
  } else if (type == "ball") {
    loop.kind = LoopKind::ball;
  } else if (type != "fixed") {
    return std::nullopt;
  }
  if (const xml::View pose = joint.child("pose")) {
    const auto numbers = numbers_in(import::text_of(pose), 6);
    const bool is_in_child = attribute_of(pose, "relative_to").empty();
    if (!numbers || !is_in_child) return std::nullopt;
    const std::vector<double>& n = *numbers;
    loop.X_CJ = {{n[0], n[1], n[2]}, from_rpy({n[3], n[4], n[5]})};
  }
  const auto poses = forward_kinematics(model, {});
  if (!poses[loop.parent] || !poses[loop.child]) return std::nullopt;
  loop.X_PJ = inverse(*poses[loop.parent]) * *poses[loop.child] * loop.X_CJ;
  return loop;
}

}  // namespace

bool is_loop_of_gazebo(const LinkedModel& model, xml::View joint) {
  return loop_of(model, joint).has_value();
}

std::vector<Loop> loops_of(const LinkedModel& model) {
  std::vector<Loop> loops;
  if (!model.robot) return loops;
  const std::vector<std::optional<Pose>> poses = forward_kinematics(model, {});
  const auto add = [&](std::optional<Loop> loop) {
    if (loop && poses[loop->parent] && poses[loop->child]) loops.push_back(std::move(*loop));
  };
  for (std::size_t i = 0; i < model.robot->joints.size(); ++i) {
    if (closes_loop(model, i)) add(loop_of(model, i));
  }
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View gazebo(model.robot->document, id);
    if (gazebo.name() != "gazebo") continue;
    for (const xml::View child : gazebo) add(loop_of(model, child));
  }
  return loops;
}

LoopGap gap_of(const Loop& loop, const std::vector<std::optional<Pose>>& poses) {
  const Pose X_JC = inverse(*poses[loop.parent] * loop.X_PJ) * *poses[loop.child] * loop.X_CJ;
  LoopGap gap;
  gap.distance = std::sqrt(dot(X_JC.position, X_JC.position));
  const Quaternion& q = X_JC.orientation;
  const Vector3 turned{q.x, q.y, q.z};
  if (loop.kind == LoopKind::fixed) {
    gap.angle = 2 * arc_tangent(std::sqrt(dot(turned, turned)), std::abs(q.w));
  } else if (loop.kind == LoopKind::hinge) {
    gap.angle = angle_between(loop.axis, rotate(q, loop.axis));
    gap.turn = std::remainder(2 * arc_tangent(dot(turned, loop.axis), q.w), 2 * std::numbers::pi);
  }
  return gap;
}

bool is_planar(const LinkedModel& model, const Loop& loop,
               const std::vector<std::optional<Pose>>& poses) {
  if (loop.kind != LoopKind::hinge) return false;
  const Vector3 axis = rotate((*poses[loop.parent] * loop.X_PJ).orientation, loop.axis);
  const auto chain_of = [&](std::size_t link) {
    std::vector<std::size_t> joints;
    while (const auto joint = model.tree.parent_joint[link]) {
      joints.push_back(to_size(*joint));
      link = to_size(*model.tree.joint_parent[to_size(*joint)]);
    }
    return joints;
  };
  std::set<std::size_t> around;  // the joints above one end only
  for (const std::size_t end : {loop.parent, loop.child}) {
    for (const std::size_t joint : chain_of(end)) {
      if (!around.insert(joint).second) around.erase(joint);
    }
  }
  return std::all_of(around.begin(), around.end(), [&](std::size_t index) {
    const urdf::Joint& joint = model.robot->joints[index];
    if (joint.type == urdf::JointType::fixed) return true;
    const std::optional<Vector3> own = joint_axis(joint);
    if (!joint.has_one_axis() || joint.type == urdf::JointType::prismatic || !own) return false;
    const Pose& X_RC = *poses[to_size(*model.tree.joint_child[index])];
    const Vector3 normal = cross(axis, unit(rotate(X_RC.orientation, *own)));
    return dot(normal, normal) < kRounding;
  });
}

}  // namespace smurf
