// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/convex_mesh.hpp"

#include <algorithm>
#include <cmath>

#include "base/deadline.hpp"
#include "base/numbers/vectors.hpp"

namespace smurf {
namespace {

/// The number after the point whose digits are those of `index` in reverse, to the base: Halton's
/// sequence, which fills an interval evenly.
double reversed_digits(unsigned index, unsigned base) {
  double value = 0;
  double weight = 1;
  for (; index > 0; index /= base) {
    weight /= base;
    value += weight * (index % base);
  }
  return value;
}

bool contains(const ConvexMesh& hull, const Vector3& point) {
  return std::all_of(hull.sides.begin(), hull.sides.end(), [&](const HalfSpace& side) {
    return dot(side.normal, point) <= side.distance;
  });
}

bool contains(const Box& box, const Vector3& point) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(point[i] >= box.low[i] && point[i] <= box.high[i])) return false;
  }
  return true;
}

/// The part of a hull that is in none of the hulls before it, 0..1.
double new_part(std::span<const ConvexMesh> hulls, std::span<const Box> boxes, std::size_t hull) {
  std::vector<std::size_t> near;
  for (std::size_t other = 0; other < hull; ++other) {
    bool meets = true;
    for (std::size_t i = 0; i < 3; ++i) {
      meets = meets && boxes[other].low[i] < boxes[hull].high[i] &&
              boxes[hull].low[i] < boxes[other].high[i];
    }
    if (meets) near.push_back(other);
  }
  if (near.empty()) return 1;
  constexpr unsigned kSamples = 4096;
  constexpr unsigned kMostTries = 64 * kSamples;  // a hull that is a needle in its box
  const Vector3 size = boxes[hull].size();
  unsigned inside = 0;
  unsigned shared = 0;
  for (unsigned i = 1; inside < kSamples && i <= kMostTries; ++i) {
    const Vector3 point{boxes[hull].low[0] + size[0] * reversed_digits(i, 2),
                        boxes[hull].low[1] + size[1] * reversed_digits(i, 3),
                        boxes[hull].low[2] + size[2] * reversed_digits(i, 5)};
    Deadline::look(hulls[hull].sides.size() / 64 + 1);
    if (!contains(hulls[hull], point)) continue;
    ++inside;
    shared += std::any_of(near.begin(), near.end(), [&](std::size_t other) {
      return contains(boxes[other], point) && contains(hulls[other], point);
    });
  }
  return inside > 0 ? 1 - static_cast<double>(shared) / inside : 1;
}

}  // namespace

Box box_of(std::span<const Vector3> points) {
  Box box{points.front(), points.front()};
  for (const Vector3& point : points) {
    for (std::size_t i = 0; i < 3; ++i) {
      box.low[i] = std::min(box.low[i], point[i]);
      box.high[i] = std::max(box.high[i], point[i]);
    }
  }
  return box;
}

std::optional<ConvexMesh> convex_mesh(std::span<const Vector3> points) {
  if (points.empty()) return std::nullopt;
  // About the middle, so that a mesh far from its origin is as precise as one around it.
  const Box box = box_of(points);
  const Vector3 middle = box.center();
  std::vector<Vector3> centred;
  centred.reserve(points.size());
  double reach = 0;
  for (const Vector3& point : points) {
    centred.push_back(difference(point, middle));
    for (const double x : centred.back()) reach = std::max(reach, std::fabs(x));
  }
  constexpr double kSinglePrecision = 4e-7;
  std::optional<std::vector<HullFace>> faces;
  // Rounding errors can exceed the tolerance where many points are nearly in one plane.
  for (double tolerance = kSinglePrecision / 8; !faces && tolerance <= kSinglePrecision;
       tolerance *= 2) {
    faces = quickhull(centred, tolerance * reach);
  }
  if (!faces) return std::nullopt;
  ConvexMesh hull;
  constexpr std::uint32_t kUnused = 0xffffffffU;
  std::vector<std::uint32_t> places(points.size(), kUnused);
  for (const HullFace& face : *faces) {
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& place = places[face.corners[k]];
      if (place == kUnused) {
        place = static_cast<std::uint32_t>(hull.points.size());
        hull.points.push_back(points[face.corners[k]]);
      }
      triangle[k] = place;
    }
    hull.triangles.push_back(triangle);
    hull.sides.push_back({face.side.normal, face.side.distance + dot(face.side.normal, middle)});
    const auto [a, b, c] = face.corners;
    hull.volume += dot(centred[a], cross(centred[b], centred[c])) / 6;
  }
  if (!(hull.volume > 0)) return std::nullopt;
  return hull;
}

double volume_of_union(std::span<const ConvexMesh> hulls) {
  std::vector<Box> boxes;
  boxes.reserve(hulls.size());
  for (const ConvexMesh& hull : hulls) boxes.push_back(box_of(hull.points));
  double volume = 0;
  for (std::size_t i = 0; i < hulls.size(); ++i) {
    volume += hulls[i].volume * new_part(hulls, boxes, i);
  }
  return volume;
}

}  // namespace smurf
