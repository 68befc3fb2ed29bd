// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/polygons.hpp"

#include <cmath>
#include <utility>

#include "base/numbers/vectors.hpp"

namespace smurf {
namespace {

constexpr std::size_t kMostCorners = 256;

void fan(std::span<const std::uint32_t> corners, std::vector<std::uint32_t>& triangles) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    triangles.insert(triangles.end(), {corners[0], corners[i - 1], corners[i]});
  }
}

/// Twice the area vector of a polygon.
Vector3 area_of(std::span<const std::uint32_t> corners, const std::vector<Vector3>& points) {
  Vector3 area{0, 0, 0};
  const Vector3& origin = points[corners[0]];
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const Vector3 part =
        cross(difference(points[corners[i - 1]], origin), difference(points[corners[i]], origin));
    for (std::size_t k = 0; k < 3; ++k) area[k] += part[k];
  }
  return area;
}

template <class Corner>
double turn(const Corner& a, const Corner& b, const Corner& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Whether all corners turn in the same direction.
template <class Corner>
bool is_convex(const std::vector<Corner>& corners) {
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (turn(corners[i], corners[(i + 1) % count], corners[(i + 2) % count]) < 0) return false;
  }
  return true;
}

}  // namespace

void PolygonSplitter::split(std::span<const std::uint32_t> corners,
                            const std::vector<Vector3>& points,
                            std::vector<std::uint32_t>& triangles) {
  if (corners.size() <= 3 || corners.size() > kMostCorners) return fan(corners, triangles);
  const Vector3 area = area_of(corners, points);
  const double sizes[] = {std::fabs(area[0]), std::fabs(area[1]), std::fabs(area[2])};
  const std::size_t flat =
      sizes[0] > sizes[1] ? (sizes[0] > sizes[2] ? 0 : 2) : (sizes[1] > sizes[2] ? 1 : 2);
  // The two other axes, in the order in which the polygon is counterclockwise.
  std::size_t x = (flat + 1) % 3;
  std::size_t y = (flat + 2) % 3;
  if (area[flat] < 0) std::swap(x, y);
  left_.clear();
  for (const std::uint32_t corner : corners) {
    left_.push_back({corner, points[corner][x], points[corner][y]});
  }
  if (is_convex(left_)) return fan(corners, triangles);
  cut(triangles);
}

bool PolygonSplitter::is_ear(std::size_t place) {
  const std::size_t count = left_.size();
  const Corner& before = left_[(place + count - 1) % count];
  const Corner& tip = left_[place];
  const Corner& after = left_[(place + 1) % count];
  if (turn(before, tip, after) <= 0) return false;
  for (const Corner& other : left_) {
    if (steps_left_ > 0) --steps_left_;
    if (other.index == before.index || other.index == tip.index || other.index == after.index) {
      continue;
    }
    if (turn(before, tip, other) >= 0 && turn(tip, after, other) >= 0 &&
        turn(after, before, other) >= 0) {
      return false;
    }
  }
  return true;
}

void PolygonSplitter::cut(std::vector<std::uint32_t>& triangles) {
  std::size_t place = 0;
  std::size_t tried = 0;
  while (left_.size() > 3 && tried < left_.size() && steps_left_ > 0) {
    const std::size_t count = left_.size();
    if (!is_ear(place)) {
      place = (place + 1) % count;
      ++tried;
      continue;
    }
    triangles.insert(triangles.end(), {left_[(place + count - 1) % count].index, left_[place].index,
                                       left_[(place + 1) % count].index});
    left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(place));
    place %= left_.size();
    tried = 0;
  }
  // A polygon without an ear crosses itself; then any triangles will do.
  for (std::size_t i = 2; i < left_.size(); ++i) {
    triangles.insert(triangles.end(), {left_[0].index, left_[i - 1].index, left_[i].index});
  }
}

}  // namespace smurf
