// SPDX-License-Identifier: BSD-3-Clause
#include "imports/mass.hpp"

#include <Eigen/Dense>
#include <cmath>

namespace smurf::imports {
namespace {

constexpr double kPi = 3.14159265358979323846;

Eigen::Matrix3d matrix_of(const Tensor& t) {
  Eigen::Matrix3d m;
  m << t[0], t[3], t[4], t[3], t[1], t[5], t[4], t[5], t[2];
  return m;
}

Eigen::Matrix3d matrix_of(const Quaternion& q) {
  const auto r = to_matrix(q);
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(r.data());
}

Tensor tensor_in(const Eigen::Matrix3d& m) {
  return {m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(0, 2), m(1, 2)};
}

/// The moment of a mass at a point.
Tensor moved(double mass, const Vector3& d) {
  return {mass * (d[1] * d[1] + d[2] * d[2]),
          mass * (d[0] * d[0] + d[2] * d[2]),
          mass * (d[0] * d[0] + d[1] * d[1]),
          -mass * d[0] * d[1],
          -mass * d[0] * d[2],
          -mass * d[1] * d[2]};
}

}  // namespace

Tensor rotated(const Tensor& tensor, const Quaternion& rotation) {
  const Eigen::Matrix3d r = matrix_of(rotation);
  return tensor_in(r * matrix_of(tensor) * r.transpose());
}

MassProperties MassProperties::in(const Pose& X) const {
  const Vector3 turned = rotate(X.orientation, center);
  return {mass,
          {X.position[0] + turned[0], X.position[1] + turned[1], X.position[2] + turned[2]},
          rotated(inertia, X.orientation)};
}

void MassProperties::add(const MassProperties& other) {
  const double sum = mass + other.mass;
  if (other.mass == 0) {
    for (std::size_t i = 0; i < 6; ++i) inertia[i] += other.inertia[i];
    return;
  }
  Vector3 middle{};
  for (std::size_t i = 0; i < 3; ++i)
    middle[i] = (mass * center[i] + other.mass * other.center[i]) / sum;
  const auto away = [&](const Vector3& c) {
    return Vector3{c[0] - middle[0], c[1] - middle[1], c[2] - middle[2]};
  };
  const Tensor a = moved(mass, away(center));
  const Tensor b = moved(other.mass, away(other.center));
  for (std::size_t i = 0; i < 6; ++i) inertia[i] += other.inertia[i] + a[i] + b[i];
  mass = sum;
  center = middle;
}

void MassProperties::scale(double factor) {
  mass *= factor;
  for (double& one : inertia) one *= factor;
}

Principal principal_of(const Tensor& tensor) {
  const bool is_diagonal = tensor[3] == 0 && tensor[4] == 0 && tensor[5] == 0;
  if (is_diagonal && tensor[0] >= tensor[1] && tensor[1] >= tensor[2])
    return {{tensor[0], tensor[1], tensor[2]}, {}};
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix_of(tensor));
  Eigen::Matrix3d axes;
  Principal result;
  for (int i = 0; i < 3; ++i) {
    result.moments[static_cast<std::size_t>(i)] = solver.eigenvalues()(2 - i);
    axes.col(i) = solver.eigenvectors().col(2 - i);
  }
  if (axes.determinant() < 0) axes.col(2) = -axes.col(2);
  const Eigen::Quaterniond q(axes);
  result.axes = {q.w(), q.x(), q.y(), q.z()};
  return result;
}

Tensor tensor_of(const Principal& principal) {
  const Vector3& m = principal.moments;
  return rotated({m[0], m[1], m[2], 0, 0, 0}, principal.axes);
}

Extent sphere(double r, bool is_shell) {
  const double moment = r * r * (is_shell ? 2.0 / 3 : 2.0 / 5);
  return {is_shell ? 4 * kPi * r * r : 4 * kPi * r * r * r / 3, {moment, moment, moment}};
}

Extent capsule(double r, double half, bool is_shell) {
  const double h = 2 * half;
  Extent e;
  if (is_shell) {
    const double round = 4 * kPi * r * r;
    const double side = 2 * kPi * r * h;
    e.volume = round + side;
    const double ms = round / e.volume;
    const double mc = side / e.volume;
    // A half shell has its centre at half of the radius.
    const double across =
        mc * (6 * r * r + h * h) / 12 + ms * (2 * r * r / 3 + h * h / 4 + h * r / 2);
    e.moments = {across, across, mc * r * r + ms * 2 * r * r / 3};
    return e;
  }
  e.volume = kPi * (r * r * h + 4 * r * r * r / 3);
  const double ms = 4 * r / (4 * r + 3 * h);
  const double mc = 1 - ms;
  const double ball = 2 * ms * r * r / 5;
  const double across = mc * (3 * r * r + h * h) / 12 + ball + ms * h * (3 * r + 2 * h) / 8;
  e.moments = {across, across, mc * r * r / 2 + ball};
  return e;
}

Extent cylinder(double r, double half, bool is_shell) {
  const double h = 2 * half;
  if (!is_shell) {
    const double across = (3 * r * r + h * h) / 12;
    return {kPi * r * r * h, {across, across, r * r / 2}};
  }
  const double caps = 2 * kPi * r * r;
  const double side = 2 * kPi * r * h;
  const double all = caps + side;
  const double across =
      side / all * (6 * r * r + h * h) / 12 + caps / all * (r * r / 4 + h * h / 4);
  return {all, {across, across, side / all * r * r + caps / all * r * r / 2}};
}

Extent ellipsoid(const std::array<double, 3>& s, bool is_shell) {
  const auto solid = [](const std::array<double, 3>& a) {
    return Extent{4 * kPi * a[0] * a[1] * a[2] / 3,
                  {(a[1] * a[1] + a[2] * a[2]) / 5, (a[0] * a[0] + a[2] * a[2]) / 5,
                   (a[0] * a[0] + a[1] * a[1]) / 5}};
  };
  const Extent inner = solid(s);
  if (!is_shell) return inner;
  // MuJoCo: the difference of two solids; its area is the approximation of Thomsen.
  constexpr double kThickness = 1e-6;
  constexpr double kPower = 1.6075;
  const Extent outer = solid({s[0] + kThickness, s[1] + kThickness, s[2] + kThickness});
  Extent shell;
  const double ab = std::pow(s[0] * s[1], kPower);
  const double bc = std::pow(s[1] * s[2], kPower);
  const double ca = std::pow(s[2] * s[0], kPower);
  shell.volume = 4 * kPi * std::pow((ab + bc + ca) / 3, 1 / kPower);
  for (std::size_t i = 0; i < 3; ++i) {
    shell.moments[i] = (outer.volume * outer.moments[i] - inner.volume * inner.moments[i]) /
                       (outer.volume - inner.volume);
  }
  return shell;
}

Extent box(const std::array<double, 3>& s, bool is_shell) {
  if (!is_shell) {
    return {8 * s[0] * s[1] * s[2],
            {(s[1] * s[1] + s[2] * s[2]) / 3, (s[0] * s[0] + s[2] * s[2]) / 3,
             (s[0] * s[0] + s[1] * s[1]) / 3}};
  }
  const double x = 2 * s[0];
  const double y = 2 * s[1];
  const double z = 2 * s[2];
  const double area = 2 * (x * y + y * z + z * x);
  // Three pairs of faces: each a plate about its own centre, moved by half of the box.
  const auto moment = [&](double a, double b, double c) {
    // About the axis along c.
    const double ends = 2 * a * b * (a * a + b * b) / 12;
    const double across_a = 2 * b * c * (b * b / 12 + a * a / 4);
    const double across_b = 2 * a * c * (a * a / 12 + b * b / 4);
    return (ends + across_a + across_b) / area;
  };
  return {area, {moment(y, z, x), moment(x, z, y), moment(x, y, z)}};
}

}  // namespace smurf::imports
