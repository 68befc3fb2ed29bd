// SPDX-License-Identifier: BSD-3-Clause
// Stage BUILD: checks that ODE accepts the bodies and joints of a plan.
#pragma once

#include "smurf-load-check/body_plan.hpp"
#include "smurf-load-check/bounds.hpp"
#include "smurf-load-check/result.hpp"

namespace smurf::load_check {

/// The fault of an inertia.
enum class InertiaFault : std::uint8_t { refused, impossible };
/// `refused` when ODE refuses such a body, `impossible` when it accepts one that cannot exist.
std::optional<InertiaFault> fault_of(const Eigen::Matrix3d& inertia);

/// Reports bodies without mass or with impossible inertia, joints without axis, and extreme mass
/// ratios, under the rules of the linter for these faults, with their effects in ODE.
std::vector<Figure> check_bodies(const Plan& plan, const Bounds& bounds, DiagnosticSink& sink);

/// Reports a body whose mass is not positive; nothing about other bodies.
void check_mass(const Plan& plan, std::size_t body, DiagnosticSink& sink);

/// The body's link nearest to the root, or for a joint "joint `a`", at its name.
struct Named {
  std::string name;
  Span place;
};
Named name_of(const Plan& plan, const LinkPlan& link);
Named name_of(const Plan& plan, const JointPlan& joint);
Named name_of_body(const Plan& plan, std::size_t body);
/// The whole model, at the name of its robot.
Span place_of(const LinkedModel& model);

}  // namespace smurf::load_check
