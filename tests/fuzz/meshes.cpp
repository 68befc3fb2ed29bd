// SPDX-License-Identifier: BSD-3-Clause
// A mesh file: its facts, and either all of its triangles or none.
#include <cmath>
#include <string_view>

#include "fuzz/bundle.hpp"
#include "fuzz/clock.hpp"
#include "mesh/mesh_reader.hpp"
#include "smurf/mesh_triangles.hpp"

using namespace smurf;
using namespace smurf::test;

namespace {

std::vector<std::string> broken_promises(const MeshTriangles& mesh) {
  std::vector<std::string> broken;
  if (mesh.reason.empty() == mesh.indices.empty()) broken.emplace_back("no triangles, no reason");
  if (mesh.points.empty() != mesh.indices.empty()) broken.emplace_back("points without triangles");
  if (mesh.indices.size() % 3 != 0) broken.emplace_back("half a triangle");
  if (mesh.parts.empty() != mesh.indices.empty()) broken.emplace_back("no parts");
  for (const auto& point : mesh.points) {
    for (const float c : point) {
      if (!std::isfinite(c)) broken.emplace_back("a point that is no point");
    }
  }
  if (!mesh.texture_points.empty() && mesh.texture_points.size() != mesh.points.size()) {
    broken.emplace_back("points without texture coordinates");
  }
  for (const TexturePoint& point : mesh.texture_points) {
    if (!std::isfinite(point[0] + point[1])) broken.emplace_back("no texture coordinates");
  }
  for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
    const bool is_last = i + 1 == mesh.parts.size();
    const std::size_t points = is_last ? mesh.points.size() : mesh.parts[i + 1].first_point;
    const std::size_t end = is_last ? mesh.indices.size() : mesh.parts[i + 1].first_index;
    for (std::size_t k = mesh.parts[i].first_index; k < end; ++k) {
      if (mesh.indices[k] < mesh.parts[i].first_point || mesh.indices[k] >= points) {
        broken.emplace_back("an index of another part");
      }
    }
  }
  return broken;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const smurf::test::Clock clock;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  // A glTF may refer to itself.
  const auto neighbours = [&](const std::string& name) {
    return name.starts_with('m') ? FileContent{ReadStatus::ok, std::string(bytes), {}}
                                 : FileContent{};
  };
  Exercise result;
  for (const char* extension : {".stl", ".obj", ".dae", ".gltf"}) {
    for (const TexturePoints wanted : {TexturePoints::ignored, TexturePoints::read}) {
      result.broken = broken_promises(read_triangles(bytes, extension, neighbours, wanted));
      require_kept(result);
    }
    read_mesh(bytes, extension, {}, neighbours);
    FileNames names;
    for (const MeshDependency& named : files_named_in(bytes, extension)) {
      names.emplace(named.filename, "other.png");
    }
    with_other_names(bytes, extension, names);
  }
  return 0;
}
