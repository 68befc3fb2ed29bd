// SPDX-License-Identifier: BSD-3-Clause
#include "write/mjcf_inertia.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>

#include "base/numbers.hpp"
#include "write/mjcf_parts.hpp"
#include "write/xml_text.hpp"

namespace smurf {
namespace {

/// The smallest eigenvalue of a full tensor that MuJoCo takes (mjEPS), and somewhat more than the
/// smallest mass and inertia of what moves (mjMINVAL).
constexpr double kLeast = 1e-14;

/// In the axes of the link.
Eigen::Matrix3d tensor_of(const LinkInertial& mass) {
  const Quaternion& q = mass.X_LC.orientation;
  const Eigen::Matrix3d R = Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
  Eigen::Matrix3d I;
  I << mass.ixx, mass.ixy, mass.ixz, mass.ixy, mass.iyy, mass.iyz, mass.ixz, mass.iyz, mass.izz;
  return R * I * R.transpose();
}

/// Makes ascending moments such that MuJoCo takes them; true when that is more than rounding.
bool repair(Eigen::Vector3d& moments, bool moves) {
  const double rounding = 1e-9 * moments.cwiseAbs().maxCoeff();
  const double least = moves ? kLeast : 0;
  bool is_changed = moments[0] < least - (moves ? 0 : rounding);
  moments = moments.cwiseMax(least);
  const double most = moments[0] + moments[1];
  is_changed = is_changed || moments[2] > most + rounding;
  moments[2] = std::min(moments[2], most);
  return is_changed;
}

}  // namespace

MjcfInertia mjcf_inertia(const LinkInertial& mass, bool moves) {
  const Eigen::Matrix3d I = tensor_of(mass);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(I);
  Eigen::Vector3d moments = solver.eigenvalues();
  MjcfInertia result{.mass = format_number(moves ? std::max(mass.mass, kLeast) : mass.mass),
                     .tensor_name = "fullinertia",
                     .tensor = {},
                     .orientation = {},
                     .is_changed = moves && mass.mass < kLeast};
  if (moments[0] > 2 * kLeast && moments[2] <= moments[0] + moments[1]) {
    result.tensor = join_numbers({I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)});
    return result;
  }
  if (repair(moments, moves)) result.is_changed = true;
  Eigen::Matrix3d axes = solver.eigenvectors();
  if (axes.determinant() < 0) axes.col(0) = -axes.col(0);
  const Eigen::Quaterniond q(axes);
  result.tensor_name = "diaginertia";
  result.tensor = join_numbers({moments[0], moments[1], moments[2]});
  result.orientation = quaternion_text({q.w(), q.x(), q.y(), q.z()});
  return result;
}

}  // namespace smurf
