// SPDX-License-Identifier: BSD-3-Clause
#include "mjcf/moved_inertia.hpp"

#include <Eigen/Cholesky>

#include "base/numbers/vectors.hpp"

namespace smurf::mjcf {
namespace {

/// A unit speed of a joint: the turning, and the velocity at the origin of the world.
struct Motion {
  std::size_t body = 0;
  Vector3 turn{}, shift{};
  double armature = 0;
  const Joint* joint = nullptr;
};

Vector3 sum_of(const Vector3& a, const Vector3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Vector3 moment_of(const Tensor& t, const Vector3& a) {
  return {t[0] * a[0] + t[3] * a[1] + t[4] * a[2], t[3] * a[0] + t[1] * a[1] + t[5] * a[2],
          t[4] * a[0] + t[5] * a[1] + t[2] * a[2]};
}

std::vector<Motion> motions_of(const Joint& joint, std::size_t body, const Pose& X_WB) {
  constexpr Vector3 kAxes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Vector3 anchor = (X_WB * Pose{joint.position, {}}).position;
  std::vector<Motion> motions;
  const auto slide = [&](const Vector3& axis) {
    motions.push_back({body, {}, axis, joint.armature, &joint});
  };
  const auto turn = [&](const Vector3& axis) {
    motions.push_back({body, axis, cross(anchor, axis), joint.armature, &joint});
  };
  const Vector3 axis = rotate(X_WB.orientation, joint.axis);
  if (joint.type == Joint::Type::slide) slide(axis);
  if (joint.type == Joint::Type::hinge) turn(axis);
  if (joint.type == Joint::Type::free) {
    for (const Vector3& one : kAxes) slide(one);
  }
  if (joint.type == Joint::Type::free || joint.type == Joint::Type::ball) {
    for (const Vector3& one : kAxes) turn(one);
  }
  return motions;
}

}  // namespace

MovedInertia::MovedInertia(const Model& model)
    : model_(model), X_WB_(model.bodies.size()), carried_(model.bodies.size()) {
  for (std::size_t i = 1; i < X_WB_.size(); ++i)
    X_WB_[i] = X_WB_[model.bodies[i].parent] * model.bodies[i].pose;
  for (std::size_t i = 0; i < X_WB_.size(); ++i) {
    if (model.bodies[i].mass) carried_[i] = model.bodies[i].mass->in(X_WB_[i]);
  }
  // A parent comes before its children.
  for (std::size_t i = X_WB_.size(); i-- > 1;) {
    std::optional<MassProperties>& parent = carried_[model.bodies[i].parent];
    if (parent && carried_[i]) {
      parent->add(*carried_[i]);
    } else {
      parent.reset();
    }
  }
}

std::optional<double> MovedInertia::locked(const Joint& joint, std::size_t body) const {
  if (!carried_[body]) return std::nullopt;
  const MassProperties& moved = *carried_[body];
  const Vector3 anchor = (X_WB_[body] * Pose{joint.position, {}}).position;
  const Vector3 away{moved.center[0] - anchor[0], moved.center[1] - anchor[1],
                     moved.center[2] - anchor[2]};
  const auto about = [&](const Vector3& a) {
    const Vector3 c = cross(a, away);
    return dot(a, moment_of(moved.inertia, a)) + moved.mass * dot(c, c);
  };
  if (joint.type == Joint::Type::slide) return joint.armature + moved.mass;
  if (joint.type == Joint::Type::hinge)
    return joint.armature + about(rotate(X_WB_[body].orientation, joint.axis));
  return joint.armature + (about({1, 0, 0}) + about({0, 1, 0}) + about({0, 0, 1})) / 3;
}

std::optional<double> MovedInertia::free(const Joint& joint) {
  if (!has_free_) find_free();
  has_free_ = true;
  const auto found = free_.find(&joint);
  return found == free_.end() ? std::nullopt : std::optional(found->second);
}

/// From the inverse of the mass matrix of the joints.
void MovedInertia::find_free() {
  constexpr std::size_t kMostMotions = 500;
  std::vector<Motion> motions;
  for (std::size_t i = 1; i < model_.bodies.size(); ++i) {
    for (const Joint& joint : model_.bodies[i].joints) {
      for (const Motion& one : motions_of(joint, i, X_WB_[i])) motions.push_back(one);
    }
    if (motions.size() > kMostMotions) return;
  }
  const auto count = static_cast<Eigen::Index>(motions.size());
  if (!carried_[0] || count == 0) return;
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(count, count);
  for (Eigen::Index j = 0; j < count; ++j) {
    const Motion& inner = motions[static_cast<std::size_t>(j)];
    const MassProperties& carried = *carried_[inner.body];
    const Vector3 at_center = sum_of(inner.shift, cross(inner.turn, carried.center));
    const Vector3 turning = moment_of(carried.inertia, inner.turn);
    // A motion moves what another one moves if its body is the same, or above it.
    std::size_t above = inner.body;
    for (Eigen::Index i = j; i >= 0; --i) {
      const Motion& outer = motions[static_cast<std::size_t>(i)];
      while (above > outer.body) above = model_.bodies[above].parent;
      if (above != outer.body) continue;
      M(i, j) = M(j, i) =
          carried.mass * dot(sum_of(outer.shift, cross(outer.turn, carried.center)), at_center) +
          dot(outer.turn, turning);
    }
    M(j, j) += inner.armature;
  }
  const Eigen::LLT<Eigen::MatrixXd> factors(M);
  if (factors.info() != Eigen::Success) return;
  const Eigen::MatrixXd inverse = factors.solve(Eigen::MatrixXd::Identity(count, count));
  for (Eigen::Index i = 0; i < count; ++i)
    free_.emplace(motions[static_cast<std::size_t>(i)].joint, 1 / inverse(i, i));
}

}  // namespace smurf::mjcf
