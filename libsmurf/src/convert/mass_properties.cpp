// SPDX-License-Identifier: BSD-3-Clause
#include "convert/mass_properties.hpp"

#include <Eigen/Geometry>

namespace smurf {
namespace {

Eigen::Matrix3d rotation(const Pose& pose) {
  const Quaternion& q = pose.orientation;
  return Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
}

Eigen::Vector3d position(const Pose& pose) {
  return {pose.position[0], pose.position[1], pose.position[2]};
}

/// The product of `a` and `b`, a matrix or a vector. Computed without Eigen, which adds in another
/// order with vector instructions, so the last digits would differ between machines.
template <class Right>
Right product(const Eigen::Matrix3d& a, const Right& b) {
  Right result;
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < b.cols(); ++column) {
      result(row, column) =
          a(row, 0) * b(0, column) + a(row, 1) * b(1, column) + a(row, 2) * b(2, column);
    }
  }
  return result;
}

/// Inertia of a point of unit mass at d: (d.d) E - d d^T.
Eigen::Matrix3d point_inertia(const Eigen::Vector3d& d) {
  const double square = d.x() * d.x() + d.y() * d.y() + d.z() * d.z();
  return square * Eigen::Matrix3d::Identity() - d * d.transpose();
}

}  // namespace

MassProperties mass_properties(const urdf::Link& link) {
  MassProperties body;
  if (!link.inertial) return body;
  const urdf::Inertial& inertial = *link.inertial;
  const auto value = [](const Field<double>& field) { return field.value_or(0); };
  body.mass = value(inertial.mass);
  body.inertia << value(inertial.ixx), value(inertial.ixy), value(inertial.ixz),  //
      value(inertial.ixy), value(inertial.iyy), value(inertial.iyz),              //
      value(inertial.ixz), value(inertial.iyz), value(inertial.izz);
  return transformed(body, urdf::to_pose(inertial.origin));
}

MassProperties transformed(const MassProperties& body_B, const Pose& X_AB) {
  const Eigen::Matrix3d R_AB = rotation(X_AB);
  const Eigen::Matrix3d R_BA = R_AB.transpose();
  return {body_B.mass, product(R_AB, body_B.center) + position(X_AB),
          product(product(R_AB, body_B.inertia), R_BA)};
}

MassProperties combined(const MassProperties& a, const MassProperties& b) {
  const double mass = a.mass + b.mass;
  MassProperties sum;
  sum.mass = mass;
  if (mass != 0) sum.center = (a.mass * a.center + b.mass * b.center) / mass;
  sum.inertia = a.inertia + a.mass * point_inertia(a.center - sum.center) + b.inertia +
                b.mass * point_inertia(b.center - sum.center);
  return sum;
}

MassProperties total(const LinkedModel& model, const std::vector<std::optional<Pose>>& poses) {
  MassProperties sum;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (!poses[i]) continue;
    sum = combined(sum, transformed(mass_properties(model.robot->links[i]), *poses[i]));
  }
  return sum;
}

}  // namespace smurf
