// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/triangle_collector.hpp"

#include <cmath>
#include <cstring>

#include "base/hash.hpp"

namespace smurf {
namespace {

/// A primitive of a preview has one colour, so the number of colours is that of its primitives.
constexpr std::size_t kMostColors = 256;
/// Larger numbers overflow in the programs that show them.
constexpr double kFarthest = 1e15;

}  // namespace

std::size_t TriangleCollector::HashOfPoint::operator()(const Point& point) const {
  std::array<char, sizeof point> bytes;
  std::memcpy(bytes.data(), point.data(), sizeof point);
  return hash_of(std::string_view(bytes.data(), bytes.size()));
}

TriangleCollector::TriangleCollector(std::size_t most_triangles)
    : most_triangles_(most_triangles), parts_(1) {
  part_of_color_.emplace(std::nullopt, 0);
}

void TriangleCollector::set_color(const std::optional<Rgba>& color) {
  const auto known = part_of_color_.find(color);
  if (known != part_of_color_.end()) {
    current_ = known->second;
  } else if (parts_.size() > kMostColors) {
    current_ = 0;
  } else {
    current_ = parts_.size();
    part_of_color_.emplace(color, current_);
    parts_.emplace_back().color = color;
  }
}

bool TriangleCollector::add(Part& part, const Vector3& point) {
  Point single{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(std::fabs(point[i]) <= kFarthest)) return false;
    single[i] = static_cast<float>(point[i]) + 0.0F;  // -0 becomes 0
  }
  const auto next = static_cast<std::uint32_t>(part.points.size());
  const auto [known, is_new] = part.known.try_emplace(single, next);
  if (is_new) part.points.push_back(single);
  part.indices.push_back(known->second);
  return true;
}

bool TriangleCollector::add(const Vector3& a, const Vector3& b, const Vector3& c) {
  if (!reason_.empty()) return false;
  Part& part = parts_[current_];
  if (++triangles_ > most_triangles_) {
    reason_ = "has more than " + std::to_string(most_triangles_) + " triangles";
  } else if (!add(part, a) || !add(part, b) || !add(part, c)) {
    reason_ = "has a coordinate that is too large";
  }
  return reason_.empty();
}

MeshTriangles TriangleCollector::take() {
  MeshTriangles mesh;
  mesh.reason = std::move(reason_);
  if (!mesh.reason.empty()) return mesh;
  for (Part& part : parts_) {
    if (part.indices.empty()) continue;
    part.known = {};
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    const auto first_index = static_cast<std::uint32_t>(mesh.indices.size());
    mesh.parts.push_back({first, first_index, part.color});
    if (mesh.points.empty()) {
      mesh.points = std::move(part.points);
      mesh.indices = std::move(part.indices);
      continue;
    }
    mesh.points.insert(mesh.points.end(), part.points.begin(), part.points.end());
    for (const std::uint32_t index : part.indices) mesh.indices.push_back(first + index);
    part.points = {};
    part.indices = {};
  }
  return mesh;
}

}  // namespace smurf
