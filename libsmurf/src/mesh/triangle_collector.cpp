// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/triangle_collector.hpp"

#include <cmath>
#include <cstring>

#include "base/numbers/hash.hpp"

namespace smurf {
namespace {

/// A primitive of a preview has one colour, so this limits the number of primitives.
constexpr std::size_t kMostColors = 256;
/// Larger numbers overflow in the programs that show them.
constexpr double kFarthest = 1e15;
/// Larger texture coordinates are a mistake: they repeat the image a million times.
constexpr double kMostRepeated = 1e6;

std::string too_many(std::size_t most) {
  return "has more than " + std::to_string(most) + " triangles";
}

}  // namespace

TexturePoint texture_point(double u, double v) {
  const bool is_sound = std::fabs(u) <= kMostRepeated && std::fabs(v) <= kMostRepeated;
  if (!is_sound) return kNoTexturePoint;
  return {static_cast<float>(u) + 0.0F, static_cast<float>(v) + 0.0F};
}

template <std::size_t Size>
std::size_t
TriangleCollector::HashOf<Size>::operator()(const std::array<float, Size>& point) const {
  std::array<char, sizeof point> bytes;
  std::memcpy(bytes.data(), point.data(), sizeof point);
  return hash_of(std::string_view(bytes.data(), bytes.size()));
}

TriangleCollector::TriangleCollector(std::size_t most_triangles, TexturePoints texture_points)
    : most_triangles_(most_triangles), texture_points_(texture_points), parts_(1) {
  part_of_color_.emplace(std::nullopt, 0);
}

TriangleCollector::TriangleCollector(std::size_t most_triangles, Visitor visit)
    : most_triangles_(most_triangles),
      visit_(std::move(visit)),
      texture_points_(TexturePoints::ignored) {}

void TriangleCollector::set_color(const std::optional<Rgba>& color) {
  if (visit_) return;
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

std::optional<TriangleCollector::Point> TriangleCollector::to_single(const Vector3& point) {
  Point single{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(std::fabs(point[i]) <= kFarthest)) return std::nullopt;
    single[i] = static_cast<float>(point[i]) + 0.0F;  // -0 becomes 0
  }
  return single;
}

bool TriangleCollector::add(Part& part, const Vector3& point) {
  const std::optional<Point> single = to_single(point);
  if (!single) return false;
  const auto next = static_cast<std::uint32_t>(part.points.size());
  const auto [known, is_new] = part.known.try_emplace(*single, next);
  if (is_new) part.points.push_back(*single);
  part.indices.push_back(known->second);
  return true;
}

bool TriangleCollector::add(Part& part, const Vector3& point, const TexturePoint& texture) {
  const std::optional<Point> single = to_single(point);
  if (!single) return false;
  const auto& [x, y, z] = *single;
  const bool has_texture = !std::isnan(texture[0]);
  if (!has_texture) lacks_texture_points_ = true;
  const TexturePoint known_texture = has_texture ? texture : TexturePoint{};
  const TexturedPoint key{x, y, z, known_texture[0], known_texture[1]};
  const auto next = static_cast<std::uint32_t>(part.points.size());
  const auto [known, is_new] = part.known_textured.try_emplace(key, next);
  if (is_new) {
    part.points.push_back(*single);
    part.texture_points.push_back(known_texture);
  }
  part.indices.push_back(known->second);
  return true;
}

bool TriangleCollector::add(const Vector3& a, const Vector3& b, const Vector3& c,
                            const TextureCorners& textures) {
  if (!reason_.empty()) return false;
  if (visit_ && ++triangles_ <= most_triangles_) {
    visit_(a, b, c);
    return true;
  }
  if (visit_) {
    reason_ = too_many(most_triangles_);
    return false;
  }
  Part& part = parts_[current_];
  const auto add_corner = [&](const Vector3& point, std::size_t corner) {
    return wants_texture_points() ? add(part, point, textures[corner]) : add(part, point);
  };
  if (++triangles_ > most_triangles_) {
    reason_ = too_many(most_triangles_);
  } else if (!add_corner(a, 0) || !add_corner(b, 1) || !add_corner(c, 2)) {
    reason_ = "has a coordinate that is too large";
  }
  return reason_.empty();
}

MeshTriangles TriangleCollector::take() {
  MeshTriangles mesh;
  mesh.reason = std::move(reason_);
  if (!mesh.reason.empty()) return mesh;
  mesh.has_textures = has_textures_;
  for (Part& part : parts_) {
    if (part.indices.empty()) continue;
    part.known = {};
    part.known_textured = {};
    if (!lacks_texture_points_) {
      mesh.texture_points.insert(mesh.texture_points.end(), part.texture_points.begin(),
                                 part.texture_points.end());
    }
    part.texture_points = {};
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
