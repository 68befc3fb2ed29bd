// SPDX-License-Identifier: BSD-3-Clause
// The meshes of a MuJoCo world. MuJoCo refuses the whole world for one mesh that it cannot read, so
// the files are read here.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "write/losses/scene_losses.hpp"
#include "write/pages/preview_meshes.hpp"
#include "write/text/xml_text.hpp"

namespace smurf {

/// Whether MuJoCo reads all of a mesh file: binary STL without other bytes after the triangles, and
/// OBJ, of which it reads the faces of the first group only. `extension` is in lower case.
bool is_mesh_of_mujoco(std::string_view extension, std::string_view bytes);

class MjcfMeshes {
 public:
  MjcfMeshes(const SceneExport& scene, XmlText& xml, SceneLosses& losses)
      : scene_(scene), xml_(xml), losses_(losses), files_(scene, kCost) {}

  /// Declares a mesh inside <asset>: by file name if MuJoCo reads the file, otherwise with its
  /// triangles. Returns the reason if there is no mesh, such as "is flat, which MuJoCo refuses", or
  /// "".
  std::string declare(const FlatMesh& mesh, Span place);
  /// Also declares the parts of a mesh that its file gives colours. Precondition: the mesh is
  /// declared.
  void declare_parts(const FlatMesh& mesh, Span place);
  /// Null if it is not declared.
  const std::string* name_of(const FlatMesh& mesh) const;

  struct Part {
    std::string name;
    std::optional<Rgba> color;  ///< of the file
  };
  /// The parts that are declared; null if there are none.
  const std::vector<Part>* parts_of(const FlatMesh& mesh) const;

 private:
  /// The fewest bytes of three numbers and of an index.
  static constexpr PreviewMeshes::Cost kCost{6, 2};

  struct MeshOfFile {
    bool is_named = true;          ///< MuJoCo reads the file; otherwise its triangles are written
    std::string reason;            ///< the reason if there is no mesh for MuJoCo
    std::optional<double> volume;  ///< before scaling; none if the file was not read
    bool is_readable = false;      ///< here
    bool has_textures = false;
    std::vector<std::optional<Rgba>> colors;  ///< of its parts
  };

  static std::string key_of(const FlatMesh& mesh);
  std::string new_name() { return "mesh_" + std::to_string(declared_++); }
  void examine(const FlatMesh& mesh, MeshOfFile& of_file) const;
  void declare_triangles(const std::string& name, const Vector3& scale,
                         const MeshTriangles& triangles);
  /// Empty if MuJoCo refuses one of them.
  std::vector<MeshTriangles> split(const FlatMesh& mesh, Span place);

  const SceneExport& scene_;
  XmlText& xml_;
  SceneLosses& losses_;
  PreviewMeshes files_;
  std::size_t declared_ = 0;
  std::map<std::string, MeshOfFile> mesh_files_;
  std::map<std::string, std::string> names_;        ///< of the declared meshes, by key_of()
  std::map<std::string, std::vector<Part>> parts_;  ///< by key_of()
};

}  // namespace smurf
