// SPDX-License-Identifier: BSD-3-Clause
#include <unordered_map>

#include "base/bits.hpp"
#include "mesh/mesh_reader.hpp"
#include "smurf/mesh_triangles.hpp"

namespace smurf {
namespace {

using Point = std::array<float, 3>;

struct HashOfPoint {
  std::size_t operator()(const Point& point) const {
    std::uint64_t hash = 0;
    for (const float coordinate : point) {
      hash = (hash ^ bit_cast<std::uint32_t>(coordinate)) * 0x9e3779b97f4a7c15U;
      hash ^= hash >> 32U;
    }
    return static_cast<std::size_t>(hash);
  }
};

/// Equal points become one.
class Collector {
 public:
  explicit Collector(MeshTriangles& mesh) : mesh_(mesh) {}

  void add(const Vector3& point) {
    Point single{};
    for (std::size_t i = 0; i < 3; ++i) {
      single[i] = static_cast<float>(point[i]) + 0.0F;  // -0 becomes 0
    }
    const auto next = static_cast<std::uint32_t>(mesh_.points.size());
    const auto [known, is_new] = indices_.try_emplace(single, next);
    if (is_new) mesh_.points.push_back(single);
    mesh_.indices.push_back(known->second);
  }

 private:
  MeshTriangles& mesh_;
  std::unordered_map<Point, std::uint32_t, HashOfPoint> indices_;
};

std::string why_none(const MeshFacts& facts, const MeshTriangles& mesh) {
  if (facts.defect) return "is broken: " + facts.defect->what;
  switch (facts.format) {
  case MeshFormat::unknown: return "is of an unknown format";
  case MeshFormat::lfs_pointer: return "is a Git LFS pointer";
  case MeshFormat::collada:
  case MeshFormat::gltf:
    return "is " + std::string(to_string(facts.format)) + ", of which no triangles are read";
  default: break;
  }
  if (facts.triangles == 0) return "has no triangles";
  // An OBJ may name points before they are there.
  return mesh.indices.size() == 3 * facts.triangles ? "" : "names points that come later";
}

}  // namespace

MeshTriangles read_triangles(std::string_view bytes, std::string_view extension) {
  MeshTriangles mesh;
  Collector collector(mesh);
  const MeshFacts facts =
      read_mesh(bytes, extension, [&](const Vector3& a, const Vector3& b, const Vector3& c) {
        for (const Vector3* corner : {&a, &b, &c}) collector.add(*corner);
      });
  std::string reason = why_none(facts, mesh);
  if (!reason.empty()) mesh = {{}, {}, std::move(reason)};
  return mesh;
}

}  // namespace smurf
