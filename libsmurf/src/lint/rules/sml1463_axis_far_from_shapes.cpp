// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "base/numbers/numbers.hpp"
#include "base/numbers/vectors.hpp"
#include "base/ranges.hpp"
#include "link/link_overlaps.hpp"
#include "lint/rigid_shapes.hpp"

namespace smurf::rules::sml1463_axis_far_from_shapes_file {
namespace {

constexpr double kFarOfChild = 0.5;   // of the size of what turns
constexpr double kFarOfParent = 0.1;  // of the size of what carries it
constexpr double kFarAlone = 5;       // of both sizes, if no other axis is at the same place
constexpr double kLeastAlone = 0.3;   // m
constexpr double kLeast = 0.02;       // m

/// Whether the frame of a joint's child is where the frame of the joint above the parent is: an
/// exporter left both where the drawing begins.
bool is_at_joint_above(const LinkedModel& model, const std::vector<std::optional<Pose>>& poses,
                       std::size_t parent, std::size_t child) {
  const auto above = model.tree.parent_joint[parent];
  if (!above || model.joint(*above).type == urdf::JointType::fixed) return false;
  const Vector3 d = difference(poses[child]->position, poses[parent]->position);
  constexpr double kSame = 1e-6;  // m
  return dot(d, d) < kSame * kSame;
}

double distance_from_axis(const Vector3& axis, const Vector3& point) {
  const double along = dot(axis, point), square = dot(axis, axis);
  return std::sqrt(std::max(0.0, dot(point, point) - along * along / square));
}

/// Whether the axis passes near to the middle of a shape of the child, as most do: near to all
/// shapes of its body then.
bool passes_near_child(const LinkedModel& model, std::size_t joint) {
  const auto child = model.tree.joint_child[joint];
  const Vector3 axis = model.robot->joints[joint].axis.value_or({1, 0, 0});
  if (!child || !(dot(axis, axis) > 0)) return true;  // such a joint is not checked
  const auto is_near = [&](const auto& part) {
    const std::optional<Box> box = bounding_box(model, part.geometry);
    if (!box) return false;
    const Box placed = moved(*box, urdf::to_pose(part.origin));
    const Vector3 size = box->size();
    const double diagonal = std::sqrt(dot(size, size));
    constexpr double kSurely = 0.99;  // as roundings differ
    return distance_from_axis(axis, placed.center()) <
           kSurely * std::max(kLeast, kFarOfChild * diagonal);
  };
  const urdf::Link& link = model.link(*child);
  return ranges::any_of(link.collisions, is_near) || ranges::any_of(link.visuals, is_near);
}

void check_joint(const LinkedModel& model, std::size_t joint,
                 const std::vector<std::optional<Pose>>& poses,
                 const std::vector<std::size_t>& body, const std::vector<RigidShape>& shapes,
                 Findings& findings) {
  const urdf::Joint& one = model.robot->joints[joint];
  const auto parent = model.tree.joint_parent[joint];
  const auto child = model.tree.joint_child[joint];
  if (!parent || !child || !poses[to_size(*child)] || !poses[to_size(*parent)]) return;
  const RigidShape& fixed = shapes[body[to_size(*parent)]];
  const RigidShape& turning = shapes[body[to_size(*child)]];
  if (!fixed.is_known || !turning.is_known || !fixed.box || !turning.box) return;
  const Vector3 axis = one.axis.value_or({1, 0, 0});
  const double length = std::sqrt(dot(axis, axis));
  if (!(length > 0)) return;
  const Pose& X = *poses[to_size(*child)];
  const Vector3 direction =
      rotate(X.orientation, {axis[0] / length, axis[1] / length, axis[2] / length});
  const double to_child = distance_from_line(X.position, direction, turning.points);
  if (to_child < std::max(kLeast, kFarOfChild * diagonal_of(*turning.box))) return;
  const double to_parent = distance_from_line(X.position, direction, fixed.points);
  const bool is_shared = is_at_joint_above(model, poses, to_size(*parent), to_size(*child));
  const double sizes = std::max(diagonal_of(*turning.box), diagonal_of(*fixed.box));
  const bool is_far =
      is_shared ? to_parent > kFarOfParent * diagonal_of(*fixed.box)
                : std::min(to_child, to_parent) > std::max(kLeastAlone, kFarAlone * sizes);
  if (!is_far) return;
  findings
      .report_habit(name_place(model, one),
                    "the axis of " + title(one) + " passes " + format_rounded(to_child, 2) +
                        " m from " + title(model.link(*child)) + ", which it turns, and " +
                        format_rounded(to_parent, 2) + " m from " + title(model.link(*parent)),
                    "such axes")
      .help(
          "write the place of the axis into the `origin` of the joint, and move the shapes and the "
          "inertial of the child back by it");
}

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  std::vector<std::size_t> doubtful;
  for (std::size_t i = 0; i < model.robot->joints.size(); ++i) {
    const urdf::JointType type = model.robot->joints[i].type;
    const bool turns = type == urdf::JointType::revolute || type == urdf::JointType::continuous;
    if (turns && !passes_near_child(model, i)) doubtful.push_back(i);
  }
  if (doubtful.empty()) return;
  const auto poses = forward_kinematics(model, {});
  const std::vector<std::size_t> body = bodies_of(model);
  const std::vector<RigidShape> shapes = rigid_shapes(model, poses, body);
  if (shapes.empty()) return;
  for (const std::size_t joint : doubtful) {
    check_joint(model, joint, poses, body, shapes, findings);
  }
}

}  // namespace

extern constinit const Rule sml1463_axis_far_from_shapes{
    .id = "SML1463",
    .name = "axis-far-from-shapes",
    .severity = Severity::warning,
    .summary = "The axis of a joint passes far from the shapes of both its links.",
    .why = "Exporters that leave all joint origins at 0 keep the meshes in the frame of the "
           "assembly: the robot looks right until a joint moves, and then its parts swing about "
           "the middle of the base.",
    .remedy = "Write the place of the axis into the origin of the joint.",
    .sources = "Boxes around all shapes, placed by forward kinematics; fusion2urdf issues 45 and "
               "50, solidworks_urdf_exporter issues 73 and 130.",
    .check_model = check,
    .about = About::robot};

}  // namespace smurf::rules::sml1463_axis_far_from_shapes_file
