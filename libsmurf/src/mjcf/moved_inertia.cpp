// SPDX-License-Identifier: BSD-3-Clause
#include "mjcf/moved_inertia.hpp"

#include "base/numbers/vectors.hpp"

namespace smurf::mjcf {

MovedInertia::MovedInertia(const Model& model)
    : X_WB_(model.bodies.size()), carried_(model.bodies.size()) {
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

std::optional<double> MovedInertia::of(const Joint& joint, std::size_t body) const {
  if (!carried_[body]) return std::nullopt;
  const MassProperties& moved = *carried_[body];
  const Vector3 anchor = (X_WB_[body] * Pose{joint.position, {}}).position;
  const Vector3 away{moved.center[0] - anchor[0], moved.center[1] - anchor[1],
                     moved.center[2] - anchor[2]};
  const Tensor& t = moved.inertia;
  const auto about = [&](const Vector3& a) {
    const Vector3 c = cross(a, away);
    return a[0] * (t[0] * a[0] + t[3] * a[1] + t[4] * a[2]) +
           a[1] * (t[3] * a[0] + t[1] * a[1] + t[5] * a[2]) +
           a[2] * (t[4] * a[0] + t[5] * a[1] + t[2] * a[2]) + moved.mass * dot(c, c);
  };
  if (joint.type == Joint::Type::slide) return joint.armature + moved.mass;
  if (joint.type == Joint::Type::hinge)
    return joint.armature + about(rotate(X_WB_[body].orientation, joint.axis));
  return joint.armature + (about({1, 0, 0}) + about({0, 1, 0}) + about({0, 0, 1})) / 3;
}

}  // namespace smurf::mjcf
