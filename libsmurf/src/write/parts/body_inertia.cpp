// SPDX-License-Identifier: BSD-3-Clause
#include "write/parts/body_inertia.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "link/possible_inertia.hpp"

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

}  // namespace

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
