// SPDX-License-Identifier: BSD-3-Clause
#include "write/parts/body_inertia.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "link/inertia.hpp"
#include "link/possible_inertia.hpp"
#include "link/shape_solids.hpp"
#include "write/losses/loss_table.hpp"

namespace smurf {
namespace {

Eigen::Matrix3d tensor_of(const LinkInertial& mass) {
  const Quaternion& q = mass.X_LC.orientation;
  const Eigen::Matrix3d R = Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
  Eigen::Matrix3d I;
  I << mass.ixx, mass.ixy, mass.ixz, mass.ixy, mass.iyy, mass.iyz, mass.ixz, mass.iyz, mass.izz;
  return R * I * R.transpose();
}

/// As make_possible().
bool repair(Eigen::Vector3d& moments, double least) {
  Vector3 ascending{moments[0], moments[1], moments[2]};
  const bool is_changed = make_possible(ascending, least);
  moments = {ascending[0], ascending[1], ascending[2]};
  return is_changed;
}

/// Returns the tensor with `moments` about the columns of `axes`.
LinkInertial principal(const LinkInertial& mass, const Eigen::Vector3d& moments,
                       Eigen::Matrix3d axes) {
  if (axes.determinant() < 0) axes.col(0) = -axes.col(0);
  const Eigen::Quaterniond q(axes);
  LinkInertial result{.mass = mass.mass, .X_LC = mass.X_LC};
  result.X_LC.orientation = {q.w(), q.x(), q.y(), q.z()};
  result.ixx = moments[0];
  result.iyy = moments[1];
  result.izz = moments[2];
  return result;
}

/// The moment of a ball of 1 mm about its centre, per kg: no real part has less.
constexpr double kLeastPerMass = 0.4e-6;  // m^2

/// A ball as dense as water, for a body of unknown shape.
LinkInertial ball_of_water(const LinkInertial& body) {
  constexpr double kDensity = 1000;  // kg/m^3
  const double radius = std::cbrt(body.mass / kDensity * 3 / (4 * std::numbers::pi));
  LinkInertial ball{.mass = body.mass, .X_LC = body.X_LC};
  ball.ixx = ball.iyy = ball.izz = 0.4 * body.mass * radius * radius;
  return ball;
}

LinkInertial filled(const Solid& solid, const LinkInertial& body) {
  const auto [xx, yy, zz, xy, xz, yz] = unit_inertia(solid);
  const double mass = body.mass;
  return {mass,     {body.X_LC.position, {}}, mass * xx, mass * xy, mass * xz, mass * yy, mass * yz,
          mass * zz};
}

/// The tensor of one, which templates and CAD tools write, where the shapes have a much smaller
/// one.
bool is_placeholder(const urdf::Inertial& inertial, const LinkInertial& of_shapes) {
  constexpr double kMuch = 10;
  return is_unit_tensor(inertial) &&
         kMuch * std::max({of_shapes.ixx, of_shapes.iyy, of_shapes.izz}) < 1;
}

}  // namespace

ChosenMass link_mass(const LinkedModel& model, const urdf::Link& link) {
  const std::optional<LinkInertial> body = inertial_of(link);
  if (!body) return {smallest_mass(), kInventedMasses};
  const auto entries = entries_of(*link.inertial);
  const bool is_written = std::any_of(entries.begin(), entries.end(),
                                      [](const Field<double>* entry) { return entry->written; });
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(tensor_of(*body));
  const bool is_useless =
      solver.eigenvalues()[2] < kLeastPerMass * body->mass || !(solver.eigenvalues()[0] > 1e-14);
  if (is_written && !is_useless && !is_unit_tensor(*link.inertial)) return {*body, {}};
  const std::optional<Solid> solid = solid_of(model, link);
  if (!is_written) {
    if (solid) return {filled(*solid, *body), kAbsentInertias};
    return is_useless ? ChosenMass{ball_of_water(*body), kAbsentInertias} : ChosenMass{*body, {}};
  }
  const LinkInertial of_shapes = solid ? filled(*solid, *body) : ball_of_water(*body);
  if (is_useless) return {of_shapes, kUselessInertias};
  const bool is_known = solid && is_placeholder(*link.inertial, of_shapes);
  return is_known ? ChosenMass{of_shapes, kUselessInertias} : ChosenMass{*body, {}};
}

void keep_meant_tensors(const LinkedModel& model, KeptMasses& masses) {
  if (!model.robot) return;
  const auto keep = [&](const urdf::Link& link) {
    const auto body = inertial_of(link);
    if (body && is_unit_tensor(*link.inertial))
      masses.insert_or_assign(&link, ChosenMass{*body, {}});
  };
  if (model.language == Language::sdf || model.language == Language::mjcf) {
    for (const urdf::Link& link : model.robot->links) keep(link);
  }
  for (const LinkAnnotation& one : model.annotations.links) {
    const auto& name = one.link ? one.link : one.name;
    const yaml::Document* document = model.document(one.span.source);
    if (!name || document == nullptr) continue;
    const yaml::View key = yaml::View(*document, one.node).find("keep_inertia");
    const auto link = model.link_names.find(*name);
    if (link && key && key.boolean().value_or(false)) keep(model.robot->links[*link]);
  }
}

ChosenMass link_mass(const SceneExport& scene, const LinkedModel& model, const urdf::Link& link) {
  if (scene.kept_masses != nullptr) {
    const auto kept = scene.kept_masses->find(&link);
    if (kept != scene.kept_masses->end()) return kept->second;
  }
  return link_mass(model, link);
}

std::array<double, 6> tensor_in_link(const LinkInertial& mass) {
  const Eigen::Matrix3d I = tensor_of(mass);
  return {I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)};
}

BodyInertia body_inertia(const LinkInertial& mass, double least, double least_in_tensor) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(tensor_of(mass));
  Eigen::Vector3d moments = solver.eigenvalues();
  const bool is_large = mass.mass >= least && moments[0] > least_in_tensor;
  if (is_large && moments[2] <= moments[0] + moments[1]) return {mass, false, false};
  const bool is_changed = repair(moments, least) || mass.mass < least;
  LinkInertial result = principal(mass, moments, solver.eigenvectors());
  result.mass = std::max(mass.mass, least);
  return {result, true, is_changed};
}

BodyInertia principal_inertia(const LinkInertial& mass, double least) {
  const bool is_diagonal = mass.ixy == 0 && mass.ixz == 0 && mass.iyz == 0;
  if (is_diagonal && std::min({mass.ixx, mass.iyy, mass.izz}) >= least) return {mass, true, false};
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(tensor_of(mass));
  if (solver.eigenvalues()[0] >= least) {
    return {principal(mass, solver.eigenvalues(), solver.eigenvectors()), true, false};
  }
  return body_inertia(mass, least, std::numeric_limits<double>::infinity());
}

}  // namespace smurf
