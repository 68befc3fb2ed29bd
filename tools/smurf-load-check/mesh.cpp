// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-load-check/mesh.hpp"

#include <assimp/MemoryIOWrapper.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <memory>

namespace smurf::load_check {
namespace {

/// What assimp sees of the disk, for the mesh and for the files that it names in turn.
class ReadableFiles final : public Assimp::IOSystem {
 public:
  explicit ReadableFiles(const ShapeFiles& from) : from_(from) {}

  bool Exists(const char* path) const override { return from_.files.is_file(path); }
  char getOsSeparator() const override { return '/'; }

  Assimp::IOStream* Open(const char* path, const char* mode) override {
    if (mode == nullptr || mode[0] != 'r') return nullptr;
    const FileContent content = from_.files.read(path, from_.limits.mesh_bytes);
    if (content.status != ReadStatus::ok) return nullptr;
    auto bytes = std::make_unique<std::uint8_t[]>(content.text.size());
    std::copy(content.text.begin(), content.text.end(), bytes.get());
    return new Assimp::MemoryIOStream(bytes.release(), content.text.size(), true);
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }

 private:
  const ShapeFiles& from_;
};

}  // namespace

std::variant<TriangleShape, std::string> read_mesh(const std::string& path,
                                                   const ShapeFiles& from) {
  Assimp::Importer importer;
  importer.SetIOHandler(new ReadableFiles(from));  // which the importer deletes
  // Points and lines become meshes of their own, which are then left out.
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  // URDF readers take the numbers of a Collada file as they are, in its own axes.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  const aiScene* scene =
      importer.ReadFile(path, aiProcess_Triangulate | aiProcess_SortByPType |
                                  aiProcess_PreTransformVertices | aiProcess_JoinIdenticalVertices);
  if (scene == nullptr) return std::string(importer.GetErrorString());
  TriangleShape shape;
  for (unsigned int i = 0; i < scene->mNumMeshes; ++i) {
    const aiMesh& mesh = *scene->mMeshes[i];
    const auto first = static_cast<std::uint32_t>(shape.points.size());
    for (unsigned int v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D& point = mesh.mVertices[v];
      shape.points.emplace_back(point.x, point.y, point.z);
    }
    for (unsigned int f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3) continue;
      shape.triangles.push_back(
          {first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]});
    }
  }
  if (shape.triangles.empty()) return std::string("it has no triangles");
  return shape;
}

}  // namespace smurf::load_check
