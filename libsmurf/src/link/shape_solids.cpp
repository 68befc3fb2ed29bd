// SPDX-License-Identifier: BSD-3-Clause
#include "link/shape_solids.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace smurf {
namespace {

/// The coordinates of the second moments in their order.
constexpr std::array<std::array<std::size_t, 2>, 6> kPairs = {
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

/// A body that is symmetric about its centre, with the mean squares of its coordinates.
Solid symmetric(double volume, double xx, double yy, double zz) {
  return {volume, {}, {volume * xx, volume * yy, volume * zz, 0, 0, 0}};
}

Solid cylinder(double radius, double length) {
  const double square = radius * radius / 4;
  return symmetric(std::numbers::pi * radius * radius * length, square, square,
                   length * length / 12);
}

Solid sphere(double radius) {
  const double square = radius * radius / 5;
  return symmetric(std::numbers::pi * radius * radius * radius * 4 / 3, square, square, square);
}

Solid capsule(double radius, double length) {
  Solid solid = cylinder(radius, length);
  const Solid caps = sphere(radius);
  // A hemisphere ends at the cylinder; its centre is 3/8 of the radius away.
  const double offset = length / 2 + radius * 3 / 8;
  for (std::size_t k = 0; k < 2; ++k) solid.second[k] += caps.second[k];
  const double own = radius * radius * (1.0 / 5 - 9.0 / 64);
  solid.second[2] += caps.volume * (own + offset * offset);
  solid.volume += caps.volume;
  return solid;
}

std::optional<Solid> scaled(const Solid& solid, const Vector3& scale) {
  const double size = std::fabs(scale[0] * scale[1] * scale[2]);
  const double sign = solid.volume < 0 ? -1 : 1;
  Solid result;
  result.volume = sign * solid.volume * size;
  for (std::size_t i = 0; i < 3; ++i) result.center[i] = solid.center[i] * scale[i];
  for (std::size_t k = 0; k < kPairs.size(); ++k) {
    const auto [i, j] = kPairs[k];
    result.second[k] = sign * solid.second[k] * size * scale[i] * scale[j];
  }
  return result;
}

/// Surfaces that cross themselves have meaningless sums.
bool is_possible(const Solid& solid, const Box& box) {
  constexpr double kLeast = 1e-6;  // of the box
  const Vector3 size = box.size();
  const double most = size[0] * size[1] * size[2];
  const double volume = std::fabs(solid.volume);
  if (!(volume > kLeast * most && volume <= most * (1 + kLeast))) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(solid.center[i] >= box.low[i] && solid.center[i] <= box.high[i])) return false;
    const double square = solid.second[i] / solid.volume;
    if (!(square > 0 && square <= size[i] * size[i] / 4)) return false;
  }
  return true;
}

std::optional<Solid> solid_of(const LinkedModel& model, const urdf::Mesh& mesh) {
  const MeshFacts* facts = find_facts(model, mesh);
  if (facts == nullptr || !facts->solid || !facts->box || facts->closure == Closure::flipped ||
      (mesh.scale.written && !mesh.scale) || !is_possible(*facts->solid, *facts->box)) {
    return std::nullopt;
  }
  Vector3 scale = mesh.scale.value_or({1, 1, 1});
  for (double& factor : scale) factor *= facts->unit_meters.value_or(1);
  return scaled(*facts->solid, scale);
}

std::optional<Solid> unchecked_solid_of(const LinkedModel& model, const urdf::Shape& shape) {
  if (const auto* mesh = std::get_if<urdf::Mesh>(&shape)) return solid_of(model, *mesh);
  if (const auto* box = std::get_if<urdf::Box>(&shape); box != nullptr && box->size) {
    const auto [x, y, z] = *box->size;
    return block({{-x / 2, -y / 2, -z / 2}, {x / 2, y / 2, z / 2}});
  }
  if (const auto* ball = std::get_if<urdf::Sphere>(&shape); ball != nullptr && ball->radius) {
    return sphere(*ball->radius);
  }
  if (const auto* tube = std::get_if<urdf::Cylinder>(&shape);
      tube != nullptr && tube->radius && tube->length) {
    return cylinder(*tube->radius, *tube->length);
  }
  if (const auto* pill = std::get_if<urdf::Capsule>(&shape);
      pill != nullptr && pill->radius && pill->length) {
    return capsule(*pill->radius, *pill->length);
  }
  return std::nullopt;
}

template <class Shapes>
std::optional<Solid> solid_of_all(const LinkedModel& model, const Shapes& shapes) {
  std::optional<Solid> all;
  for (const auto& one : shapes) {
    const std::optional<Solid> solid = solid_of(model, one.geometry);
    if (!solid) return std::nullopt;
    const Solid in_link = moved(*solid, urdf::to_pose(one.origin));
    all = all ? joined(*all, in_link) : in_link;
  }
  return all;
}

}  // namespace

const MeshReference* find_reference(const LinkedModel& model, std::uint32_t begin) {
  const auto found = std::lower_bound(
      model.meshes.begin(), model.meshes.end(), begin,
      [](const MeshReference& one, std::uint32_t place) { return one.span.begin < place; });
  return found != model.meshes.end() && found->span.begin == begin ? &*found : nullptr;
}

const MeshReference* find_reference(const LinkedModel& model, const urdf::Mesh& mesh) {
  const MeshReference* found = find_reference(model, mesh.filename.span.begin);
  const bool is_there = found != nullptr && found->span == mesh.filename.span;
  return mesh.filename && is_there ? found : nullptr;
}

const MeshFacts* find_facts(const LinkedModel& model, const urdf::Mesh& mesh) {
  const MeshReference* reference = find_reference(model, mesh);
  if (reference == nullptr || reference->file == nullptr) return nullptr;
  return reference->file->status == ReadStatus::ok ? &reference->file->facts : nullptr;
}

bool is_gltf(const LinkedModel& model, const urdf::Geometry& geometry) {
  const auto* mesh = std::get_if<urdf::Mesh>(&geometry.shape);
  const MeshFacts* facts = mesh != nullptr ? find_facts(model, *mesh) : nullptr;
  return facts != nullptr && facts->format == MeshFormat::gltf;
}

std::optional<Solid> solid_of(const LinkedModel& model, const urdf::Geometry& geometry) {
  const std::optional<Solid> solid = unchecked_solid_of(model, geometry.shape);
  if (!solid || !(solid->volume > 0) || !std::isfinite(solid->volume)) return std::nullopt;
  return solid;
}

Solid block(const Box& box) {
  const Vector3 size = box.size();
  Solid solid = symmetric(size[0] * size[1] * size[2], size[0] * size[0] / 12,
                          size[1] * size[1] / 12, size[2] * size[2] / 12);
  solid.center = box.center();
  return solid;
}

Solid moved(const Solid& solid_B, const Pose& X_AB) {
  Solid solid_A = solid_B;
  solid_A.center = (X_AB * Pose{solid_B.center, {}}).position;
  if (X_AB.orientation == Quaternion{}) return solid_A;
  const std::array<double, 9> R = to_matrix(X_AB.orientation);
  const auto& s = solid_B.second;
  const double second[3][3] = {{s[0], s[3], s[4]}, {s[3], s[1], s[5]}, {s[4], s[5], s[2]}};
  for (std::size_t k = 0; k < kPairs.size(); ++k) {
    const auto [i, j] = kPairs[k];
    double sum = 0;
    for (std::size_t m = 0; m < 3; ++m) {
      for (std::size_t n = 0; n < 3; ++n) sum += R[3 * i + m] * second[m][n] * R[3 * j + n];
    }
    solid_A.second[k] = sum;
  }
  return solid_A;
}

Solid joined(const Solid& a, const Solid& b) {
  Solid sum;
  sum.volume = a.volume + b.volume;
  for (std::size_t i = 0; i < 3; ++i) {
    sum.center[i] = (a.volume * a.center[i] + b.volume * b.center[i]) / sum.volume;
  }
  for (std::size_t k = 0; k < kPairs.size(); ++k) {
    const auto [i, j] = kPairs[k];
    sum.second[k] = a.second[k] + b.second[k] +
                    a.volume * (a.center[i] - sum.center[i]) * (a.center[j] - sum.center[j]) +
                    b.volume * (b.center[i] - sum.center[i]) * (b.center[j] - sum.center[j]);
  }
  return sum;
}

std::array<double, 6> unit_inertia(const Solid& solid) {
  std::array<double, 6> mean = solid.second;
  for (double& square : mean) square /= solid.volume;
  return {mean[1] + mean[2], mean[0] + mean[2], mean[0] + mean[1], -mean[3], -mean[4], -mean[5]};
}

std::optional<Solid> solid_of(const LinkedModel& model, const urdf::Link& link) {
  const std::optional<Solid> seen = solid_of_all(model, link.visuals);
  return seen ? seen : solid_of_all(model, link.collisions);
}

}  // namespace smurf
