// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-load-check/stand_ins.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "smurf-load-check/bodies.hpp"

namespace smurf::load_check {
namespace {

constexpr double kLightest = 1e-9;  // kg; the inertia of smaller masses is lost in rounding

double mean_mass(const Plan& plan) {
  double sum = 0;
  std::size_t count = 0;
  for (const BodyPlan& body : plan.bodies) {
    if (!is_sound(body.mass)) continue;
    sum += body.mass.mass;
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 1;
}

MassProperties ball_of_water(double mass, const Eigen::Vector3d& center) {
  constexpr double kDensity = 1000;  // kg/m^3
  const double radius = std::cbrt(3 * mass / (4 * std::numbers::pi * kDensity));
  return {mass, center, 0.4 * mass * radius * radius * Eigen::Matrix3d::Identity()};
}

/// Whether the joint had no axis direction.
bool complete_axes(JointPlan& joint) {
  const bool lacks_first = joint.axis_W.isZero();
  const bool lacks_second = joint.kind == JointKind::universal && joint.axis2_W.isZero();
  if (lacks_first) joint.axis_W = Eigen::Vector3d::UnitX();
  if (lacks_second) joint.axis2_W = joint.axis_W.unitOrthogonal();
  return lacks_first || lacks_second;
}

}  // namespace

bool is_sound(const MassProperties& mass) {
  return mass.mass > 0 && std::isfinite(mass.mass) && !fault_of(mass.inertia);
}

std::size_t add_stand_ins(Plan& plan) {
  const double usual = mean_mass(plan);
  std::size_t count = 0;
  for (BodyPlan& body : plan.bodies) {
    if (is_sound(body.mass)) continue;
    const bool has_mass = body.mass.mass > kLightest && std::isfinite(body.mass.mass);
    const Pose& X_WL = plan.links[body.first_link].X_WL;
    body.mass = has_mass ? ball_of_water(body.mass.mass, body.mass.center)
                         : ball_of_water(usual, to_eigen(X_WL.position));
    body.is_stand_in = true;
    ++count;
  }
  for (JointPlan& joint : plan.joints) count += complete_axes(joint) ? 1 : 0;
  return count;
}

}  // namespace smurf::load_check
