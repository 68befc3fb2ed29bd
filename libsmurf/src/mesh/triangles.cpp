// SPDX-License-Identifier: BSD-3-Clause
#include <limits>

#include "mesh/formats.hpp"
#include "mesh/mesh_reader.hpp"
#include "smurf/mesh_triangles.hpp"

namespace smurf {
namespace {

MeshFacts read_plain_facts(std::string_view bytes, std::string_view extension,
                           const MeshNeighbours& neighbours, TriangleCollector& triangles) {
  if (format_of_mesh(bytes, extension) == MeshFormat::obj) {
    return read_obj_triangles(bytes, neighbours, triangles);
  }
  return read_mesh(bytes, extension, [&](const Vector3& a, const Vector3& b, const Vector3& c) {
    triangles.add(a, b, c);
  });
}

/// Reads a format that does not place its triangles by nodes.
std::string read_plain(std::string_view bytes, std::string_view extension,
                       const MeshNeighbours& neighbours, TriangleCollector& triangles) {
  const MeshFacts facts = read_plain_facts(bytes, extension, neighbours, triangles);
  if (facts.defect) return why_broken(*facts.defect);
  if (facts.format == MeshFormat::unknown) return "is of an unknown format";
  if (facts.format == MeshFormat::lfs_pointer) return "is a Git LFS pointer";
  // An OBJ may refer to points that come later.
  if (triangles.reason().empty() && triangles.triangles() != facts.triangles) {
    return "refers to points that come later in the file";
  }
  return {};
}

}  // namespace

std::string why_broken(const MeshDefect& defect) {
  return "is broken: " + defect.what +
         (defect.line > 0 ? " (line " + std::to_string(defect.line) + ")" : "");
}

MeshTriangles read_triangles(std::string_view bytes, std::string_view extension,
                             const MeshNeighbours& neighbours, TexturePoints texture_points) {
  const MeshFormat format = format_of_mesh(bytes, extension);
  const bool has_nodes = format == MeshFormat::collada || format == MeshFormat::gltf;
  TriangleCollector triangles(has_nodes ? kMostPlaced : std::numeric_limits<std::size_t>::max(),
                              texture_points);
  std::string reason = format == MeshFormat::collada ? read_collada_triangles(bytes, triangles)
                       : format == MeshFormat::gltf
                           ? read_gltf_triangles(bytes, neighbours, triangles)
                           : read_plain(bytes, extension, neighbours, triangles);
  if (reason.empty()) reason = triangles.reason();
  if (reason.empty() && triangles.triangles() == 0) reason = "has no triangles";
  if (!reason.empty()) return {{}, {}, std::move(reason)};
  return triangles.take();
}

}  // namespace smurf
