// SPDX-License-Identifier: BSD-3-Clause
// The triangles of COLLADA and glTF, compared with those of assimp, the mesh reader of RViz. assimp
// is asked to ignore <up_axis>, as RViz asks it. It leaves the y axis of glTF up, which RViz turns
// after reading.
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <doctest/doctest.h>

#include <assimp/Importer.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>

#include "mesh/random_collada.hpp"
#include "mesh/random_gltf.hpp"
#include "mesh/shape.hpp"
#include "smurf/mesh_triangles.hpp"
#include "support/temporary_folder.hpp"

using namespace smurf;
using namespace smurf::test;

namespace {

/// SMURF_TEST_CASES sets another number of files.
std::size_t files_to_compare() {
  const char* given = std::getenv("SMURF_TEST_CASES");
  return given != nullptr ? std::strtoull(given, nullptr, 10) : 400;
}

void write(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

std::optional<ShapeSums> read_by_assimp(const std::string& path, bool turns_y_to_z) {
  Assimp::Importer importer;
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  const aiScene* scene = importer.ReadFile(path, aiProcess_Triangulate | aiProcess_SortByPType |
                                                     aiProcess_PreTransformVertices);
  if (scene == nullptr) return std::nullopt;
  ShapeSums sums;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
    const aiMesh& mesh = *scene->mMeshes[m];
    const auto point = [&](unsigned index) -> Vector3 {
      const aiVector3D& p = mesh.mVertices[index];
      return turns_y_to_z ? Vector3{p.x, -p.z, p.y} : Vector3{p.x, p.y, p.z};
    };
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const unsigned* corners = mesh.mFaces[f].mIndices;
      sums.add(point(corners[0]), point(corners[1]), point(corners[2]));
    }
  }
  return sums;
}

ShapeSums sums_of(const MeshTriangles& mesh) {
  ShapeSums sums;
  const auto point = [&](std::uint32_t index) -> Vector3 {
    const auto& p = mesh.points[index];
    return {p[0], p[1], p[2]};
  };
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    sums.add(point(mesh.indices[i]), point(mesh.indices[i + 1]), point(mesh.indices[i + 2]));
  }
  return sums;
}

ShapeSums read_here(const std::string& path) {
  const MeshTriangles mesh = read_triangles_of(path, DiskFiles(), Limits{});
  CAPTURE(mesh.reason);
  REQUIRE(mesh.reason.empty());
  return sums_of(mesh);
}

}  // namespace

TEST_CASE("assimp: places the triangles of COLLADA in the same way") {
  Random random;
  const TemporaryFolder folder;
  for (std::size_t i = 0; i < files_to_compare(); ++i) {
    const std::string file = random_collada(random);
    write(folder / "m.dae", file);
    const auto theirs = read_by_assimp(folder / "m.dae", false);
    CAPTURE(i);
    CAPTURE(seed());
    CAPTURE(file);
    REQUIRE(theirs);
    const ShapeSums ours = read_here(folder / "m.dae");
    CHECK(ours.triangles > 0);
    REQUIRE(ours.difference(*theirs) == "");
  }
}

TEST_CASE("assimp: places the triangles of glTF in the same way") {
  Random random;
  const TemporaryFolder folder;
  for (std::size_t i = 0; i < files_to_compare(); ++i) {
    const GltfFile file = random_gltf(random);
    write(folder / file.name, file.bytes);
    for (const auto& [name, bytes] : file.beside) write(folder / name, bytes);
    const auto theirs = read_by_assimp(folder / file.name, true);
    CAPTURE(i);
    CAPTURE(seed());
    CAPTURE(file.bytes);
    REQUIRE(theirs);
    const ShapeSums ours = read_here(folder / file.name);
    CHECK(ours.triangles > 0);
    REQUIRE(ours.difference(*theirs) == "");
  }
}

/// Not run automatically, because it needs files of the user, and because assimp reads some files
/// differently.
TEST_CASE("assimp: the files in the folder SMURF_TEST_MESHES" *
          doctest::skip(std::getenv("SMURF_TEST_MESHES") == nullptr)) {
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::getenv("SMURF_TEST_MESHES"))) {
    const std::string extension = entry.path().extension().string();
    const bool is_collada = extension == ".dae";
    if (!is_collada && extension != ".gltf" && extension != ".glb") continue;
    const MeshTriangles mesh = read_triangles_of(entry.path().string(), DiskFiles(), Limits{});
    const auto theirs = read_by_assimp(entry.path().string(), !is_collada);
    std::string found = theirs ? "is read by assimp alone: " + mesh.reason : "is read here alone";
    if (!theirs && !mesh.reason.empty()) found = "is read by none: " + mesh.reason;
    if (theirs && mesh.reason.empty()) {
      found = sums_of(mesh).difference(*theirs);
      if (found.empty()) found = "is the same";
    }
    MESSAGE(entry.path().string() << " " << found);
  }
}
