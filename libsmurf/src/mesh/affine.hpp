// SPDX-License-Identifier: BSD-3-Clause
// Transforms of the nodes of mesh files, which may scale and shear. The results are identical on
// every system.
#pragma once

#include <array>
#include <cstddef>

#include "smurf/pose.hpp"

namespace smurf {

struct Affine {
  /// Three rows of four numbers; the last column is the translation.
  std::array<double, 12> rows{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

  Vector3 operator*(const Vector3& p) const {
    Vector3 moved;
    for (std::size_t i = 0; i < 3; ++i) {
      const double* row = &rows[4 * i];
      moved[i] = row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3];
    }
    return moved;
  }
};

inline Affine operator*(const Affine& a, const Affine& b) {
  Affine product;
  for (std::size_t i = 0; i < 3; ++i) {
    const double* row = &a.rows[4 * i];
    for (std::size_t k = 0; k < 4; ++k) {
      product.rows[4 * i + k] =
          row[0] * b.rows[k] + row[1] * b.rows[4 + k] + row[2] * b.rows[8 + k];
    }
    product.rows[4 * i + 3] += row[3];
  }
  return product;
}

inline Affine translation(const Vector3& by) {
  return {{1, 0, 0, by[0], 0, 1, 0, by[1], 0, 0, 1, by[2]}};
}

inline Affine scaling(const Vector3& by) {
  return {{by[0], 0, 0, 0, 0, by[1], 0, 0, 0, 0, by[2], 0}};
}

/// `by` has unit length.
inline Affine rotation(const Quaternion& by) {
  const std::array<double, 9> m = to_matrix(by);
  return {{m[0], m[1], m[2], 0, m[3], m[4], m[5], 0, m[6], m[7], m[8], 0}};
}

}  // namespace smurf
