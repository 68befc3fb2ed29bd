// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-load-check/mesh.hpp"

#include <assimp/MemoryIOWrapper.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/BaseImporter.h>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <memory>
#include <set>
#include <variant>

#include "base/path.hpp"
#include "mesh/mesh_reader.hpp"
#include "smurf/mesh_triangles.hpp"

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

/// Only what URDFs use and nothing else here reads: assimp has sixty more readers, some of which
/// crash or never end on a broken file.
void keep_importers(Assimp::Importer& importer) {
  constexpr std::array<const char*, 3> kKept = {"dae", "gltf", "glb"};
  std::vector<Assimp::BaseImporter*> others;
  for (std::size_t i = 0; i < importer.GetImporterCount(); ++i) {
    Assimp::BaseImporter* const reader = importer.GetImporter(i);
    std::set<std::string> extensions;
    reader->GetExtensionList(extensions);
    const bool is_kept = std::any_of(kKept.begin(), kKept.end(), [&](const char* extension) {
      return extensions.contains(extension);
    });
    if (!is_kept) others.push_back(reader);
  }
  for (Assimp::BaseImporter* const reader : others) {
    importer.UnregisterLoader(reader);
    delete reader;  // no longer the importer's
  }
}

std::variant<TriangleShape, std::string> read_by_assimp(const std::string& path,
                                                        const ShapeFiles& from) {
  Assimp::Importer importer;
  keep_importers(importer);
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
  const FileContent content = from.files.read(path, from.limits.mesh_bytes);
  if (content.status == ReadStatus::denied) return {{}, content.reason, true};
  if (content.status != ReadStatus::ok) return {{}, content.reason, false};
  const std::string_view extension = path::extension(path);
  const MeshFormat format = smurf::read_mesh(content.text, extension).format;
  if (format == MeshFormat::collada || format == MeshFormat::gltf) {
    auto read = read_by_assimp(path, from);
    if (auto* reason = std::get_if<std::string>(&read)) return {{}, std::move(*reason), false};
    return {std::get<TriangleShape>(std::move(read)), {}, false};
  }
  const MeshTriangles mesh = read_triangles(content.text, extension);
  if (!mesh.reason.empty()) return {{}, "it " + mesh.reason, false};
  return {to_shape(mesh), {}, false};
}

}  // namespace smurf::load_check
