// SPDX-License-Identifier: BSD-3-Clause
// The meshes of a page that shows a scene. Each is written once, however many shapes use it.
#pragma once

#include <map>
#include <utility>

#include "write/json_printer.hpp"
#include "write/preview_meshes.hpp"

namespace smurf {

class ViewerMeshes {
 public:
  struct Known {
    std::optional<std::size_t> index;  ///< in what print() writes
    std::string why_none;
    bool has_textures = false;  ///< of its own, which are not shown
  };

  /// `scene` must outlive this. With `has_copies`, files with the same triangles, as two versions
  /// of a scene have them, are written once.
  ViewerMeshes(const SceneExport& scene, bool has_copies);

  /// `place` is that of the shape that uses the file.
  const Known& find(const std::string& file, Span place);
  /// The mesh with its texture coordinates; no index when it has none.
  const Known& find_textured(const std::string& file, Span place);

  /// Counts a shape that is not shown because of its file.
  void add_unseen(const std::string& file, const std::string& why) { ++unseen_[{file, why}]; }

  /// Prints all meshes that were found, in the order of their indices.
  void print(JsonPrinter& json) const;
  /// Prints the mesh files that are not shown, each with the reason and the number of shapes that
  /// use it.
  void print_unseen(JsonPrinter& json) const;

 private:
  struct Shown {
    std::string file, points, indices, texture_points;  ///< all but the first in base64
    std::vector<MeshPart> parts;
    bool is_wide = false;  ///< four bytes an index, else two
  };
  Known read(const std::string& file, Span place, TexturePoints texture_points);
  Known add(const std::string& file, const MeshTriangles& mesh);
  static void print_parts(const std::vector<MeshPart>& parts, JsonPrinter& json);

  PreviewMeshes files_;
  bool has_copies_;
  std::map<std::string, Known> known_, textured_;
  std::vector<Shown> shown_;
  std::map<std::pair<std::string, std::string>, std::size_t> unseen_;
};

}  // namespace smurf
