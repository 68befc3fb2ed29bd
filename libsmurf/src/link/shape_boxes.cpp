// SPDX-License-Identifier: BSD-3-Clause
#include "link/shape_boxes.hpp"

#include <algorithm>
#include <cmath>

#include "link/shape_solids.hpp"

namespace smurf {
namespace {

Box centered(double x, double y, double z) {
  return {{-x / 2, -y / 2, -z / 2}, {x / 2, y / 2, z / 2}};
}

std::optional<Box> mesh_box(const LinkedModel& model, const urdf::Mesh& mesh) {
  const MeshFacts* facts = find_facts(model, mesh);
  if (facts == nullptr || !facts->box || (mesh.scale.written && !mesh.scale)) return std::nullopt;
  const Vector3 scale = mesh.scale.value_or({1, 1, 1});
  const double unit = facts->unit_meters.value_or(1);
  Box box;
  for (std::size_t i = 0; i < 3; ++i) {
    const double a = facts->box->low[i] * unit * scale[i];
    const double b = facts->box->high[i] * unit * scale[i];
    box.low[i] = std::min(a, b);
    box.high[i] = std::max(a, b);
  }
  return box;
}

std::optional<Box> box_of(const LinkedModel& model, const urdf::Shape& shape) {
  if (const auto* mesh = std::get_if<urdf::Mesh>(&shape)) return mesh_box(model, *mesh);
  if (const auto* box = std::get_if<urdf::Box>(&shape)) {
    if (!box->size) return std::nullopt;
    return centered((*box->size)[0], (*box->size)[1], (*box->size)[2]);
  }
  if (const auto* sphere = std::get_if<urdf::Sphere>(&shape)) {
    if (!sphere->radius) return std::nullopt;
    return centered(2 * *sphere->radius, 2 * *sphere->radius, 2 * *sphere->radius);
  }
  if (const auto* cylinder = std::get_if<urdf::Cylinder>(&shape)) {
    if (!cylinder->radius || !cylinder->length) return std::nullopt;
    return centered(2 * *cylinder->radius, 2 * *cylinder->radius, *cylinder->length);
  }
  if (const auto* capsule = std::get_if<urdf::Capsule>(&shape)) {
    if (!capsule->radius || !capsule->length) return std::nullopt;
    return centered(2 * *capsule->radius, 2 * *capsule->radius,
                    *capsule->length + 2 * *capsule->radius);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Box> box_of(const LinkedModel& model, const urdf::Geometry& geometry) {
  const std::optional<Box> box = box_of(model, geometry.shape);
  if (!box) return std::nullopt;
  for (std::size_t i = 0; i < 3; ++i) {
    // False for NaN.
    if (!(std::isfinite(box->low[i]) && box->high[i] >= box->low[i])) return std::nullopt;
  }
  return box;
}

Box moved(const Box& box, const Pose& X_AB) {
  const Vector3 size = box.size();
  Vector3 center = box.center();
  Vector3 reach{size[0] / 2, size[1] / 2, size[2] / 2};
  if (X_AB.orientation != Quaternion{}) {
    center = rotate(X_AB.orientation, center);
    const std::array<double, 9> R_AB = to_matrix(X_AB.orientation);
    const Vector3 half = reach;
    for (std::size_t i = 0; i < 3; ++i) {
      reach[i] = 0;
      for (std::size_t j = 0; j < 3; ++j) reach[i] += std::fabs(R_AB[3 * i + j]) * half[j];
    }
  }
  Box around;
  for (std::size_t i = 0; i < 3; ++i) {
    around.low[i] = X_AB.position[i] + center[i] - reach[i];
    around.high[i] = X_AB.position[i] + center[i] + reach[i];
  }
  return around;
}

}  // namespace smurf
