// SPDX-License-Identifier: BSD-3-Clause
#include "conversion/mesh_copies.hpp"

#include <algorithm>

#include "base/files/path.hpp"
#include "base/numbers/floating.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/unique_names.hpp"
#include "render/printable.hpp"
#include "smurf/mesh_triangles.hpp"
#include "write/mjcf/mjcf_meshes.hpp"

namespace smurf {
namespace {

using Reads = bool (*)(std::string_view extension, std::string_view bytes);

bool is_gltf_or_obj(std::string_view extension, std::string_view) {
  return extension == ".obj" || extension == ".gltf" || extension == ".vtk";
}

/// Bullet reads COLLADA, and of STL only the binary form.
bool is_mesh_of_bullet(std::string_view extension, std::string_view bytes) {
  return extension == ".dae" || extension == ".obj" ||
         (extension == ".stl" && is_mesh_of_mujoco(extension, bytes));
}

/// Readers that load few formats; all others are null.
Reads formats_of(const Reader& reader) {
  const std::string_view name = reader.name.substr(0, reader.name.find(':'));
  if (name == "drake") return is_gltf_or_obj;
  if (name == "mujoco") return is_mesh_of_mujoco;
  if (name == "pybullet") return is_mesh_of_bullet;
  return nullptr;
}

class ObjText {
 public:
  ObjText(const MeshTriangles& mesh, const std::string& name) {
    const bool has_colors =
        std::any_of(mesh.parts.begin(), mesh.parts.end(),
                    [](const MeshPart& part) { return part.color.has_value(); });
    if (has_colors) obj = "mtllib " + name + ".mtl\n";
    for (const auto& point : mesh.points) {
      obj += 'v';
      for (const float coordinate : point) obj += ' ' + shortest(coordinate);
      obj += '\n';
    }
    std::size_t part = 0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      for (; has_colors && part < mesh.parts.size() && mesh.parts[part].first_index <= i; ++part) {
        use(part, mesh.parts[part].color.value_or(Rgba{0.5, 0.5, 0.5, 1}));
      }
      obj += 'f';
      for (std::size_t k = i; k < i + 3; ++k) obj += ' ' + std::to_string(mesh.indices[k] + 1);
      obj += '\n';
    }
  }

  std::string obj;
  std::string materials;  ///< empty: no colours

 private:
  void use(std::size_t part, const Rgba& color) {
    const std::string name = "part_" + std::to_string(part + 1);
    obj += "usemtl " + name + '\n';
    materials += "newmtl " + name + "\nKd " + format_number(color[0]) + ' ' +
                 format_number(color[1]) + ' ' + format_number(color[2]) + "\nd " +
                 format_number(color[3]) + '\n';
  }
};

}  // namespace

MeshCopies copies_for(const Reader& reader, const LinkedModel& model, const FileReader& files,
                      const Limits& limits) {
  MeshCopies copies;
  const Reads reads = formats_of(reader);
  if (reads == nullptr) return copies;
  UniqueNames names;
  for (const MeshReference& mesh : model.meshes) {
    if (mesh.is_texture || !mesh.exists || copies.names.contains(mesh.path)) continue;
    const FileContent content = files.read(mesh.path, limits.mesh_bytes);
    const std::string extension = path::to_lower(path::extension(mesh.path));
    if (content.status != ReadStatus::ok || reads(extension, content.text)) continue;
    const MeshTriangles triangles = read_triangles_of(mesh.path, files, limits);
    if (!triangles.reason.empty() || triangles.indices.empty()) continue;
    const std::string file = render::safe_file_name(path::file_name(mesh.path));
    const std::string stem = names.add(file.substr(0, file.size() - path::extension(file).size()));
    ObjText text(triangles, stem);
    copies.names.emplace(mesh.path, stem + ".obj");
    copies.files.push_back({stem + ".obj", std::move(text.obj)});
    if (!text.materials.empty()) copies.files.push_back({stem + ".mtl", std::move(text.materials)});
  }
  return copies;
}

}  // namespace smurf
