// SPDX-License-Identifier: BSD-3-Clause
#include "write/pages/preview_meshes.hpp"

#include <algorithm>

#include "base/findings/limits.hpp"
#include "base/findings/rules.hpp"

namespace smurf {

bool has_colors(const std::vector<MeshPart>& parts) {
  return std::any_of(parts.begin(), parts.end(),
                     [](const MeshPart& part) { return part.color.has_value(); });
}

const std::string& PreviewMeshes::first_name(const std::string& file) {
  const auto [known, is_new] = by_name_.try_emplace(file);
  if (is_new) {
    const auto& identity = scene_.meshes.identity;
    known->second = by_identity_.try_emplace(identity ? identity(file) : file, file).first->second;
  }
  return known->second;
}

MeshTriangles PreviewMeshes::read(const std::string& file, Span place,
                                  TexturePoints texture_points) {
  if (!scene_.meshes.triangles) return {{}, {}, "is not available"};
  const std::uint64_t most = scene_.meshes.most_bytes;
  if (bytes_ <= most) {
    MeshTriangles mesh = scene_.meshes.triangles(file, texture_points);
    bytes_ += cost_.point_bytes * mesh.points.size() + cost_.index_bytes * mesh.indices.size() +
              cost_.texture_point_bytes * mesh.texture_points.size();
    if (bytes_ <= most) return mesh;
    scene_.losses
        .report(rules::sml5022_too_many_instances, place,
                "with this mesh, the meshes written for the scene exceed " + std::to_string(most) +
                    " bytes")
        .help(raise_limit("scene-bytes"));
  }
  return {{}, {}, "is too large to write"};
}

}  // namespace smurf
