// SPDX-License-Identifier: BSD-3-Clause
#include "link/possible_inertia.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace smurf {
namespace {

Eigen::Matrix3d matrix_of(const Tensor& t) {
  Eigen::Matrix3d matrix;
  matrix << t[0], t[3], t[4], t[3], t[1], t[5], t[4], t[5], t[2];
  return matrix;
}

Tensor entries_of(const Eigen::Matrix3d& m) {
  return {m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(0, 2), m(1, 2)};
}

}  // namespace

Principal principal_of(const Tensor& tensor) {
  double scale = 0;
  for (const double entry : tensor) scale = std::max(scale, std::fabs(entry));
  Principal principal{{}, {1, 0, 0, 0, 1, 0, 0, 0, 1}};
  if (!(scale > 0)) return principal;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix_of(tensor) / scale);
  for (Eigen::Index i = 0; i < 3; ++i) {
    principal.moments[static_cast<std::size_t>(i)] = solver.eigenvalues()[i] * scale;
    for (Eigen::Index row = 0; row < 3; ++row) {
      principal.axes[static_cast<std::size_t>(3 * row + i)] = solver.eigenvectors()(row, i);
    }
  }
  return principal;
}

Tensor tensor_of(const Principal& principal) {
  Eigen::Matrix3d axes;
  for (Eigen::Index i = 0; i < 9; ++i) {
    axes(i / 3, i % 3) = principal.axes[static_cast<std::size_t>(i)];
  }
  const Eigen::Vector3d moments(principal.moments[0], principal.moments[1], principal.moments[2]);
  return entries_of(axes * moments.asDiagonal() * axes.transpose());
}

Tensor rotated(const Tensor& tensor, const Quaternion& rotation) {
  const std::array<double, 9> m = to_matrix(rotation);
  Eigen::Matrix3d R;
  R << m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8];
  return entries_of(R * matrix_of(tensor) * R.transpose());
}

Tensor shifted(const Tensor& tensor, double factor, const Vector3& offset) {
  const Eigen::Vector3d d(offset[0], offset[1], offset[2]);
  const Eigen::Matrix3d point = d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose();
  return entries_of(matrix_of(tensor) + factor * point);
}

bool make_possible(Vector3& moments, double least) {
  double largest = 0;
  for (const double moment : moments) largest = std::max(largest, std::fabs(moment));
  const double rounding = 1e-9 * largest;
  bool is_changed = moments[0] < least - (least > 0 ? 0 : rounding);
  for (double& moment : moments) moment = std::max(moment, least);
  const double most = moments[0] + moments[1];
  is_changed = is_changed || moments[2] > most + rounding;
  moments[2] = std::min(moments[2], most);
  return is_changed;
}

Tensor nearest_possible(const Tensor& tensor) {
  constexpr double kThinnest = 1e-3;  // the smallest moment, relative to the largest
  constexpr double kMargin = 1e-6;    // what the largest moment is lowered by, for rounding
  Principal principal = principal_of(tensor);
  make_possible(principal.moments, kThinnest * std::fabs(principal.moments[2]));
  const double most = (principal.moments[0] + principal.moments[1]) * (1 - kMargin);
  principal.moments[2] = std::min(principal.moments[2], most);
  return tensor_of(principal);
}

}  // namespace smurf
