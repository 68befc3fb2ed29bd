// SPDX-License-Identifier: BSD-3-Clause
#include "write/parts/unit_meshes.hpp"

#include <cmath>
#include <numbers>

#include "base/numbers/exact_math.hpp"

namespace smurf {
namespace {

using Point = std::array<float, 3>;

constexpr std::uint16_t kAround = 24;  ///< segments of a full turn

/// Point on the unit circle; exact on the axes.
std::array<float, 2> on_circle(int step, int steps) {
  const auto [sine, cosine] = sine_cosine(2 * std::numbers::pi * step / steps);
  const auto round = [](double value) {
    return static_cast<float>(std::fabs(value) < 1e-15 ? 0 : value);
  };
  return {round(cosine), round(sine)};
}

std::uint16_t add(TriangleMesh& mesh, const Point& point, const Point& normal) {
  mesh.points.push_back(point);
  mesh.normals.push_back(normal);
  return static_cast<std::uint16_t>(mesh.points.size() - 1);
}

void add_triangle(TriangleMesh& mesh, int a, int b, int c) {
  for (const int index : {a, b, c}) mesh.indices.push_back(static_cast<std::uint16_t>(index));
}

/// A parallelogram around `center`; its normal is u x v.
void add_face(TriangleMesh& mesh, const Point& center, const Point& u, const Point& v,
              const Point& normal) {
  const int first = static_cast<int>(mesh.points.size());
  for (const auto& [a, b] : {std::pair(-0.5F, -0.5F), std::pair(0.5F, -0.5F), std::pair(0.5F, 0.5F),
                             std::pair(-0.5F, 0.5F)}) {
    Point point{};
    for (std::size_t i = 0; i < 3; ++i) point[i] = center[i] + a * u[i] + b * v[i];
    add(mesh, point, normal);
  }
  add_triangle(mesh, first, first + 1, first + 2);
  add_triangle(mesh, first, first + 2, first + 3);
}

/// A disk at height z, seen from above or below.
void add_disk(TriangleMesh& mesh, float z, bool is_seen_from_above) {
  const Point normal{0, 0, is_seen_from_above ? 1.0F : -1.0F};
  const int center = add(mesh, {0, 0, z}, normal);
  for (int step = 0; step <= kAround; ++step) {
    const auto [x, y] = on_circle(step, kAround);
    add(mesh, {x, y, z}, normal);
  }
  for (int step = 1; step <= kAround; ++step) {
    const int a = center + step;
    add_triangle(mesh, center, is_seen_from_above ? a : a + 1, is_seen_from_above ? a + 1 : a);
  }
}

TriangleMesh unit_square() {
  TriangleMesh mesh;
  add_face(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  return mesh;
}

TriangleMesh unit_box() {
  TriangleMesh mesh;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const float side : {1.0F, -1.0F}) {
      Point normal{};
      Point u{};
      Point v{};
      normal[axis] = side;
      u[(axis + 1) % 3] = side;
      v[(axis + 2) % 3] = 1;
      Point center{};
      center[axis] = side / 2;
      add_face(mesh, center, u, v, normal);
    }
  }
  return mesh;
}

TriangleMesh unit_cylinder() {
  TriangleMesh mesh;
  for (int step = 0; step <= kAround; ++step) {
    const auto [x, y] = on_circle(step, kAround);
    const int below = add(mesh, {x, y, -0.5F}, {x, y, 0});
    add(mesh, {x, y, 0.5F}, {x, y, 0});
    if (step == 0) continue;
    add_triangle(mesh, below - 2, below, below + 1);
    add_triangle(mesh, below - 2, below + 1, below - 1);
  }
  add_disk(mesh, 0.5F, true);
  add_disk(mesh, -0.5F, false);
  return mesh;
}

TriangleMesh unit_sphere() {
  TriangleMesh mesh;
  constexpr int kRings = kAround / 2;
  for (int ring = 0; ring <= kRings; ++ring) {
    // The first half of a circle, from the south pole to the north pole.
    const auto [down, radius] = on_circle(ring, 2 * kRings);
    for (int step = 0; step <= kAround; ++step) {
      const auto [x, y] = on_circle(step, kAround);
      const Point point{radius * x, radius * y, -down};
      const int here = add(mesh, point, point);
      if (ring == 0 || step == 0) continue;
      const int below = here - kAround - 1;
      if (ring > 1) add_triangle(mesh, below - 1, below, here);
      if (ring < kRings) add_triangle(mesh, below - 1, here, here - 1);
    }
  }
  return mesh;
}

}  // namespace

TriangleMesh unit_mesh(UnitShape solid) {
  switch (solid) {
  case UnitShape::box: return unit_box();
  case UnitShape::sphere: return unit_sphere();
  case UnitShape::cylinder: return unit_cylinder();
  case UnitShape::square: break;
  }
  return unit_square();
}

std::vector<PlacedSolid> solids_of(const FlatGeometry& geometry) {
  if (const auto* box = std::get_if<FlatBox>(&geometry)) return {{UnitShape::box, {}, box->size}};
  if (const auto* sphere = std::get_if<FlatSphere>(&geometry)) {
    const double r = sphere->radius;
    return {{UnitShape::sphere, {}, {r, r, r}}};
  }
  if (const auto* cylinder = std::get_if<FlatCylinder>(&geometry)) {
    return {{UnitShape::cylinder, {}, {cylinder->radius, cylinder->radius, cylinder->length}}};
  }
  if (const auto* capsule = std::get_if<FlatCapsule>(&geometry)) {
    const double r = capsule->radius;
    const double half = capsule->length / 2;
    return {{UnitShape::cylinder, {}, {r, r, capsule->length}},
            {UnitShape::sphere, {{0, 0, -half}, {}}, {r, r, r}},
            {UnitShape::sphere, {{0, 0, half}, {}}, {r, r, r}}};
  }
  if (const auto* plane = std::get_if<FlatPlane>(&geometry)) {
    return {{UnitShape::square, {}, {plane->length, plane->width, 1}}};
  }
  return {};
}

}  // namespace smurf
