// SPDX-License-Identifier: BSD-3-Clause
// Inertia tensors of possible bodies.
#pragma once

#include <array>

#include "smurf/pose.hpp"

namespace smurf {

/// Entries xx, yy, zz, xy, xz and yz, kg m^2.
using Tensor = std::array<double, 6>;

/// Principal moments, ascending, and their axes as the columns of a matrix of three rows.
struct Principal {
  Vector3 moments{};
  std::array<double, 9> axes{};
};
Principal principal_of(const Tensor& tensor);
Tensor tensor_of(const Principal& principal);

/// R I R^T, where R turns by `rotation`.
Tensor rotated(const Tensor& tensor, const Quaternion& rotation);
/// Adds `factor` times the inertia of a point at `offset` from the axes.
Tensor shifted(const Tensor& tensor, double factor, const Vector3& offset);

/// Raises ascending moments to `least`, and lowers the largest until a body can have them. True if
/// the change is larger than rounding.
bool make_possible(Vector3& moments, double least);
/// The nearest tensor of a possible body that is not a point, a plane or a rod.
Tensor nearest_possible(const Tensor& tensor);

}  // namespace smurf
