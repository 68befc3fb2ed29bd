// SPDX-License-Identifier: BSD-3-Clause
#include "lint/copied_side.hpp"

#include <algorithm>
#include <cmath>

#include "link/inertia.hpp"
#include "link/possible_inertia.hpp"
#include "lint/body.hpp"
#include "lint/inertia_slips.hpp"

namespace smurf {
namespace {

/// The index of the axis along which the shapes of two links are mirrored, if they are, and do not
/// have their middle in the plane between.
std::optional<std::size_t> mirrored_axis(const Extent& a, const Extent& b) {
  constexpr double kSame = 0.02;  // of the longest edge
  constexpr double kAside = 0.05;
  const double edge = std::max(a.longest_edge(), b.longest_edge());
  std::optional<std::size_t> axis;
  for (std::size_t i = 0; i < 3; ++i) {
    const double one = (a.low[i] + a.high[i]) / 2;
    const double other = (b.low[i] + b.high[i]) / 2;
    const double size = (a.high[i] - a.low[i]) - (b.high[i] - b.low[i]);
    if (std::fabs(size) > kSame * edge) return std::nullopt;
    if (std::fabs(one - other) <= kSame * edge) continue;
    const bool is_mirrored =
        std::fabs(one + other) <= kSame * edge && std::fabs(one) > kAside * edge;
    if (!is_mirrored || axis) return std::nullopt;
    axis = i;
  }
  return axis;
}

bool are_products_copied(const urdf::Inertial& left, const urdf::Inertial& right,
                         std::size_t axis) {
  if (!principal_moments(left) || !principal_moments(right)) return false;
  const Tensor of_left = tensor_of(left);
  const Tensor of_right = tensor_of(right);
  constexpr double kNoise = 0.02;  // of the sum of the moments
  const double noise = kNoise * (of_left[0] + of_left[1] + of_left[2]);
  const auto& products = kMirroredProducts[axis];
  return std::any_of(std::begin(products), std::end(products), [&](std::size_t i) {
    return std::fabs(of_left[i]) > noise && std::fabs(of_left[i] - of_right[i]) < noise / 10;
  });
}

}  // namespace

std::optional<CopiedSide> copied_side(const urdf::Link& left, const urdf::Link& right,
                                      ModelAnswers& answers) {
  const std::optional<Extent>& a = answers.extent(left);
  const std::optional<Extent>& b = answers.extent(right);
  const auto axis = a && b ? mirrored_axis(*a, *b) : std::nullopt;
  if (!axis) return std::nullopt;
  constexpr double kAside = 0.02;  // of the longest edge
  const double least = kAside * a->longest_edge();
  const Pose one = urdf::to_pose(left.inertial->origin);
  const Pose other = urdf::to_pose(right.inertial->origin);
  if (one.orientation != other.orientation) return std::nullopt;
  const bool is_center = std::fabs(one.position[*axis]) > least &&
                         std::fabs(one.position[*axis] - other.position[*axis]) < least / 10;
  if (!is_center && !are_products_copied(*left.inertial, *right.inertial, *axis))
    return std::nullopt;
  return CopiedSide{*axis, is_center};
}

}  // namespace smurf
