// SPDX-License-Identifier: BSD-3-Clause
#include "lint/axis_order.hpp"

#include <algorithm>
#include <cmath>

#include "link/shape_solids.hpp"
#include "lint/body.hpp"
#include "lint/inertia_slips.hpp"
#include "lint/model_answers.hpp"

namespace smurf {
namespace {

/// The moments about the axes of the link, as parts of their sum.
Vector3 parts_of(const Tensor& tensor) {
  const double sum = tensor[0] + tensor[1] + tensor[2];
  return {tensor[0] / sum, tensor[1] / sum, tensor[2] / sum};
}

double difference_of(const Vector3& a, const Vector3& b) {
  return std::max({std::fabs(a[0] - b[0]), std::fabs(a[1] - b[1]), std::fabs(a[2] - b[2])});
}

/// The axes of the link are those of the body.
bool is_along_axes(const Tensor& tensor) {
  constexpr double kSmall = 0.03;  // of the sum of the moments
  const double most = kSmall * (tensor[0] + tensor[1] + tensor[2]);
  return std::fabs(tensor[3]) < most && std::fabs(tensor[4]) < most && std::fabs(tensor[5]) < most;
}

constexpr AxisOrder kOrders[] = {{{1, 0, 2}, "x and y are swapped"},
                                 {{2, 1, 0}, "x and z are swapped"},
                                 {{0, 2, 1}, "y and z are swapped"},
                                 {{1, 2, 0}, "x, y and z are read as y, z and x"},
                                 {{2, 0, 1}, "x, y and z are read as z, x and y"}};

/// The order in which the moments fit the shape; null if they fit as they are, or not at all.
const AxisOrder* order_that_fits(const Vector3& written, const Vector3& shape) {
  constexpr double kClose = 0.025;
  constexpr double kFar = 0.12;
  if (difference_of(written, shape) < kFar) return nullptr;
  const AxisOrder* best = nullptr;
  double least = kClose;
  for (const AxisOrder& order : kOrders) {
    const Vector3 ordered{written[order.axes[0]], written[order.axes[1]], written[order.axes[2]]};
    const double difference = difference_of(ordered, shape);
    if (difference >= least) continue;
    best = &order;
    least = difference;
  }
  return best;
}

/// Whether the moments are those of the shape apart from their order.
bool is_of_size(const Tensor& tensor, double mass, const Tensor& unit) {
  constexpr double kMost = 4;  // hollow parts, and shapes that are simplified
  const double factor =
      (tensor[0] + tensor[1] + tensor[2]) / (mass * (unit[0] + unit[1] + unit[2]));
  return factor < kMost && factor > 1 / kMost;
}

/// An inertia in another order may then be right.
bool has_gltf(const LinkedModel& model, const urdf::Link& link) {
  const auto is_one = [&](const auto& part) { return is_gltf(model, part.geometry); };
  return std::any_of(link.visuals.begin(), link.visuals.end(), is_one) ||
         std::any_of(link.collisions.begin(), link.collisions.end(), is_one);
}

}  // namespace

const AxisOrder* likely_axis_order(const LinkedModel& model, const urdf::Link& link,
                                   ModelAnswers& answers) {
  const std::optional<Body>& body = answers.body(link);
  if (!body || body->mass < kNegligibleMass || !answers.extent(link)) return nullptr;
  const std::optional<Tensor>& shape = answers.shape_inertia(link);
  if (!shape || has_gltf(model, link)) return nullptr;
  const Tensor tensor =
      rotated(tensor_of(*link.inertial), urdf::to_pose(link.inertial->origin).orientation);
  if (!is_along_axes(tensor) || !is_along_axes(*shape)) return nullptr;
  if (!is_of_size(tensor, body->mass, *shape)) return nullptr;
  return order_that_fits(parts_of(tensor), parts_of(*shape));
}

}  // namespace smurf
