// SPDX-License-Identifier: BSD-3-Clause
#include "conversion/mesh_pieces.hpp"

#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "base/numbers/vectors.hpp"

namespace smurf {
namespace {

/// Tells which points are connected by triangles.
class ConnectedPoints {
 public:
  explicit ConnectedPoints(const CollisionBody& body) : above_(body.points.size()) {
    std::iota(above_.begin(), above_.end(), 0U);
    for (std::size_t i = 0; i + 2 < body.indices.size(); i += 3) {
      connect(body.indices[i], body.indices[i + 1]);
      connect(body.indices[i], body.indices[i + 2]);
    }
  }

  /// A point that stands for all that are connected with this one.
  std::uint32_t root(std::uint32_t point) {
    while (above_[point] != point) {
      above_[point] = above_[above_[point]];
      point = above_[point];
    }
    return point;
  }

 private:
  void connect(std::uint32_t a, std::uint32_t b) { above_[root(a)] = root(b); }

  std::vector<std::uint32_t> above_;
};

/// Each edge joins two triangles that face the same side.
bool is_closed(const CollisionBody& body) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t i = 0; i + 2 < body.indices.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!edges.emplace(body.indices[i + k], body.indices[i + (k + 1) % 3]).second) return false;
    }
  }
  for (const auto& [from, to] : edges) {
    if (!edges.contains({to, from})) return false;
  }
  return true;
}

}  // namespace

CollisionBody body_of(const MeshTriangles& mesh, const Vector3& scale) {
  CollisionBody body;
  std::map<std::array<float, 3>, std::uint32_t> known;
  std::vector<std::uint32_t> places;  // by point of the mesh
  for (const std::array<float, 3>& point : mesh.points) {
    const auto [place, is_new] =
        known.try_emplace(point, static_cast<std::uint32_t>(body.points.size()));
    places.push_back(place->second);
    if (!is_new) continue;
    body.points.push_back({point[0] * scale[0], point[1] * scale[1], point[2] * scale[2]});
  }
  const bool is_mirrored = scale[0] * scale[1] * scale[2] < 0;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const std::uint32_t a = places[mesh.indices[i]];
    const std::uint32_t b = places[mesh.indices[i + (is_mirrored ? 2 : 1)]];
    const std::uint32_t c = places[mesh.indices[i + (is_mirrored ? 1 : 2)]];
    if (a != b && b != c && c != a) body.indices.insert(body.indices.end(), {a, b, c});
  }
  return body;
}

double volume_of(const CollisionBody& body) {
  double volume = 0;
  const auto at = [&](std::size_t i) {
    return difference(body.points[body.indices[i]], body.points.front());
  };
  for (std::size_t i = 0; i + 2 < body.indices.size(); i += 3)
    volume += dot(at(i), cross(at(i + 1), at(i + 2))) / 6;
  return volume;
}

std::vector<BodyPiece> closed_pieces(const CollisionBody& body) {
  ConnectedPoints connected(body);
  std::map<std::uint32_t, std::size_t> numbers;  // of pieces, by root
  std::vector<BodyPiece> pieces;
  constexpr std::uint32_t kUnused = 0xffffffffU;
  std::vector<std::uint32_t> places(body.points.size(), kUnused);
  for (const std::uint32_t point : body.indices) {
    const auto [number, is_new] = numbers.try_emplace(connected.root(point), pieces.size());
    if (is_new) pieces.emplace_back();
    CollisionBody& piece = pieces[number->second].body;
    if (places[point] == kUnused) {
      places[point] = static_cast<std::uint32_t>(piece.points.size());
      piece.points.push_back(body.points[point]);
    }
    piece.indices.push_back(places[point]);
  }
  for (BodyPiece& piece : pieces) {
    piece.volume = volume_of(piece.body);
    if (!(piece.volume > 0) || !is_closed(piece.body)) return {};
  }
  return pieces;
}

}  // namespace smurf
