// SPDX-License-Identifier: BSD-3-Clause
// A joint of a plan in ODE.
#pragma once

#include <ode/ode.h>

#include "smurf-load-check/body_plan.hpp"
#include "smurf-load-check/world.hpp"

namespace smurf::load_check {

/// The pose of a body; null: the world.
Pose pose_of(dBodyID body);

class OdeJoint {
 public:
  /// The bodies are in the poses of the plan; a null parent is the world. The plan must outlive the
  /// joint. `stop_margin` is as in WorldSetup.
  OdeJoint(dWorldID world, const JointPlan& plan, dBodyID parent, dBodyID child,
           double stop_margin);

  /// Call it before every step of the world, which has the length `step` (s).
  void prepare(double step) const;

  JointError error() const;
  /// Hinge: rad; slider: m; 0 for the others.
  double position() const;

 private:
  void make_hinge();
  void make_slider();
  void make_universal();
  void make_ball();
  void make_planar();
  void set_stops(void (*set)(dJointID, int, dReal)) const;
  Eigen::Vector3d in_world(dBodyID body, const Eigen::Vector3d& direction_B) const;
  /// Vector from the anchor in the parent to that in the child.
  Eigen::Vector3d apart() const;

  const JointPlan& plan_;
  double stop_margin_;
  dWorldID world_;
  dBodyID parent_, child_;
  dJointID joint_ = nullptr;  ///< none: floating
  dJointID tilt_ = nullptr;   ///< planar: prevents the child from tilting
  Eigen::Vector3d anchor_P_, anchor_C_;
};

}  // namespace smurf::load_check
