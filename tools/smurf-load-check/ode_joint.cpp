// SPDX-License-Identifier: BSD-3-Clause
// The child is the first body of every joint, so that positions grow as in the URDF.
#include "smurf-load-check/ode_joint.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace smurf::load_check {
namespace {

using Vector = Eigen::Vector3d;

double angle_between_axes(const Vector& a, const Vector& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

Pose pose_of(dBodyID body) {
  if (body == nullptr) return {};
  const dReal* p = dBodyGetPosition(body);
  const dReal* q = dBodyGetQuaternion(body);
  return {{p[0], p[1], p[2]}, {q[0], q[1], q[2], q[3]}};
}

OdeJoint::OdeJoint(dWorldID world, const JointPlan& plan, dBodyID parent, dBodyID child,
                   double stop_margin)
    : plan_(plan),
      stop_margin_(stop_margin),
      world_(world),
      parent_(parent),
      child_(child),
      anchor_P_(to_world(inverse(pose_of(parent)), plan.anchor_W)),
      anchor_C_(to_world(inverse(pose_of(child)), plan.anchor_W)) {
  switch (plan.kind) {
  case JointKind::hinge: make_hinge(); break;
  case JointKind::slider: make_slider(); break;
  case JointKind::universal: make_universal(); break;
  case JointKind::ball: make_ball(); break;
  case JointKind::planar: make_planar(); break;
  case JointKind::floating: break;
  }
}

void OdeJoint::set_stops(void (*set)(dJointID, int, dReal)) const {
  if (!plan_.stops) return;
  double lower = plan_.stops->first - plan_.start;
  double upper = plan_.stops->second - plan_.start;
  if (std::fabs(lower) < stop_margin_) lower = -stop_margin_;
  if (std::fabs(upper) < stop_margin_) upper = stop_margin_;
  set(joint_, dParamLoStop, lower);
  set(joint_, dParamHiStop, upper);
}

void OdeJoint::make_hinge() {
  joint_ = dJointCreateHinge(world_, nullptr);
  dJointAttach(joint_, child_, parent_);
  dJointSetHingeAnchor(joint_, plan_.anchor_W[0], plan_.anchor_W[1], plan_.anchor_W[2]);
  dJointSetHingeAxis(joint_, plan_.axis_W[0], plan_.axis_W[1], plan_.axis_W[2]);
  set_stops(dJointSetHingeParam);
}

void OdeJoint::make_slider() {
  joint_ = dJointCreateSlider(world_, nullptr);
  dJointAttach(joint_, child_, parent_);
  dJointSetSliderAxis(joint_, plan_.axis_W[0], plan_.axis_W[1], plan_.axis_W[2]);
  set_stops(dJointSetSliderParam);
}

void OdeJoint::make_universal() {
  joint_ = dJointCreateUniversal(world_, nullptr);
  dJointAttach(joint_, child_, parent_);
  dJointSetUniversalAnchor(joint_, plan_.anchor_W[0], plan_.anchor_W[1], plan_.anchor_W[2]);
  // ODE's first axis belongs to its first body, the child.
  dJointSetUniversalAxis1(joint_, plan_.axis2_W[0], plan_.axis2_W[1], plan_.axis2_W[2]);
  dJointSetUniversalAxis2(joint_, plan_.axis_W[0], plan_.axis_W[1], plan_.axis_W[2]);
}

void OdeJoint::make_ball() {
  joint_ = dJointCreateBall(world_, nullptr);
  dJointAttach(joint_, child_, parent_);
  dJointSetBallAnchor(joint_, plan_.anchor_W[0], plan_.anchor_W[1], plan_.anchor_W[2]);
}

/// ODE has no planar joint. Motors of unlimited force at speed zero remove the same three freedoms:
/// one along the normal, and one about each of two axes in the plane. The child cannot tilt, so the
/// point of the first motor does not matter.
void OdeJoint::make_planar() {
  const int relative_to = parent_ == nullptr ? 0 : 2;
  const Vector& normal = plan_.axis_W;
  joint_ = dJointCreateLMotor(world_, nullptr);
  dJointAttach(joint_, child_, parent_);
  dJointSetLMotorNumAxes(joint_, 1);
  dJointSetLMotorAxis(joint_, 0, relative_to, normal[0], normal[1], normal[2]);
  dJointSetLMotorParam(joint_, dParamFMax, dInfinity);
  tilt_ = dJointCreateAMotor(world_, nullptr);
  dJointAttach(tilt_, child_, parent_);
  dJointSetAMotorMode(tilt_, dAMotorUser);
  dJointSetAMotorNumAxes(tilt_, 2);
  const Vector first = normal.unitOrthogonal();
  const Vector second = normal.cross(first);
  dJointSetAMotorAxis(tilt_, 0, relative_to, first[0], first[1], first[2]);
  dJointSetAMotorAxis(tilt_, 1, relative_to, second[0], second[1], second[2]);
  dJointSetAMotorParam(tilt_, dParamFMax1, dInfinity);
  dJointSetAMotorParam(tilt_, dParamFMax2, dInfinity);
}

/// A motor controls speed only, so drift is corrected in the same way as in ODE's own joints.
void OdeJoint::prepare(double step) const {
  if (plan_.kind != JointKind::planar) return;
  const double rate = dWorldGetERP(world_) / step;
  const Vector normal_P = in_world(parent_, plan_.axis_W);
  const Vector normal_C = in_world(child_, plan_.axis_W);
  dJointSetLMotorParam(joint_, dParamVel, -rate * apart().dot(normal_P));
  const Vector back = rate * normal_C.cross(normal_P);
  const Vector first = plan_.axis_W.unitOrthogonal();
  const Vector second = plan_.axis_W.cross(first);
  dJointSetAMotorParam(tilt_, dParamVel1, back.dot(in_world(parent_, first)));
  dJointSetAMotorParam(tilt_, dParamVel2, back.dot(in_world(parent_, second)));
}

JointError OdeJoint::error() const {
  const Vector gap = apart();
  const Vector axis_P = in_world(parent_, plan_.axis_W);
  switch (plan_.kind) {
  case JointKind::hinge:
    return {gap.norm(), angle_between_axes(axis_P, in_world(child_, plan_.axis_W))};
  case JointKind::slider:
    return {(gap - gap.dot(axis_P) * axis_P).norm(),
            angle_between(pose_of(parent_).orientation, pose_of(child_).orientation)};
  case JointKind::universal: {
    const double now = angle_between_axes(axis_P, in_world(child_, plan_.axis2_W));
    return {gap.norm(), std::fabs(now - angle_between_axes(plan_.axis_W, plan_.axis2_W))};
  }
  case JointKind::ball: return {gap.norm(), 0};
  case JointKind::planar:
    return {std::fabs(gap.dot(axis_P)), angle_between_axes(axis_P, in_world(child_, plan_.axis_W))};
  case JointKind::floating: break;
  }
  return {};
}

double OdeJoint::position() const {
  switch (plan_.kind) {
  case JointKind::hinge: return plan_.start + dJointGetHingeAngle(joint_);
  case JointKind::slider: return plan_.start + dJointGetSliderPosition(joint_);
  default: return 0;
  }
}

/// Bodies start with the axes of the world.
Vector OdeJoint::in_world(dBodyID body, const Vector& direction_B) const {
  return to_eigen(
      rotate(pose_of(body).orientation, {direction_B[0], direction_B[1], direction_B[2]}));
}

Vector OdeJoint::apart() const {
  return to_world(pose_of(child_), anchor_C_) - to_world(pose_of(parent_), anchor_P_);
}

}  // namespace smurf::load_check
