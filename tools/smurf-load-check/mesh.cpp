// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-load-check/mesh.hpp"

#include "smurf/mesh_triangles.hpp"

namespace smurf::load_check {
namespace {

TriangleShape to_shape(const MeshTriangles& mesh) {
  TriangleShape shape;
  shape.points.reserve(mesh.points.size());
  for (const auto& [x, y, z] : mesh.points) shape.points.emplace_back(x, y, z);
  shape.triangles.reserve(mesh.indices.size() / 3);
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    shape.triangles.push_back({mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
  }
  return shape;
}

}  // namespace

MeshReading read_mesh(const std::string& path, const ShapeFiles& from) {
  const FileContent without_text = from.files.read(path, 0);
  if (without_text.status == ReadStatus::denied) return {{}, without_text.reason, true};
  const MeshTriangles mesh = read_triangles_of(path, from.files, from.limits);
  if (!mesh.reason.empty()) return {{}, "it " + mesh.reason, false};
  return {to_shape(mesh), {}, false};
}

}  // namespace smurf::load_check
